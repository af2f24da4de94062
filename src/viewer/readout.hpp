// Readout: what is known of one mass or spring that was clicked, now and over the last seconds, from the masses as they
// are drawn.
#pragma once

#include "picking.hpp"
#include "run/simulation.hpp"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

/// One number of what is read.
struct Quantity {
    const char* name;
    const char* unit;
    const char* about;  // a sentence for a person
    int decimals;
    std::optional<double> value;  // in the unit; none where it is not known yet
};

class Readout {
public:
    static constexpr double kept = 5.0;  // s of simulated time

    void choose(const Selection& selection);
    void close() { chosen_.reset(); }
    const std::optional<Selection>& chosen() const { return chosen_; }

    /// Takes in the masses as they are drawn; a mass has a speed where they come with velocities. What is no part of
    /// another grid is read no more.
    void observe(const Snapshot& snapshot, const Scene& scene);

    const glm::dvec3& place() const { return place_; }  // m, of the mass, or of the spring's middle
    /// What is read, the same ones for every mass and for every spring.
    const std::vector<Quantity>& quantities() const { return quantities_; }
    /// "Mass 12, 5", "Spring 12, 5 to 13, 5": columns and rows are counted from 0 at the upper
    /// corner of the hoist, as in files of states.
    std::string title() const;

    struct Sample {
        double time = 0.0;  // s
        std::vector<Quantity> quantities;
    };
    const std::deque<Sample>& past() const { return past_; }  // the oldest first

private:
    void read_mass(const Snapshot& snapshot, const Model& model);
    void read_spring(const Snapshot& snapshot, const Model& model);
    void remember(double time);

    std::optional<Selection> chosen_;
    glm::dvec3 place_{0.0};
    std::vector<Quantity> quantities_;
    std::deque<Sample> past_;
};

/// Of the spring from one mass to another, as `selection` has it.
double rest_length(const Grid& grid, const Selection& spring);        // m
double spring_constant(const Model& model, const Selection& spring);  // N/m; 0 where there is none

}  // namespace drapeau
