// Basis: all that the motions of one scene are judged by, without the flights themselves: what a report says of it.
#pragma once

#include "measure/reference_flight.hpp"
#include "measure/tip_statistics.hpp"

#include <vector>

namespace drapeau {

struct Basis {
    struct Reference {
        long long rk4_steps = 0, leapfrog_steps = 0;
        double rk4_error = 0.0, leapfrog_error = 0.0, methods_apart = 0.0;  // m
    };
    double time = 0.0;      // s, where what is compared begins
    long long batches = 0;  // of 1/60 s, compared
    bool is_shortened = false;
    Growth growth;
    TipStatistics tip;
    std::vector<Reference> references;  // one a model that is compared

    void add(const ReferenceFlight& r) {
        references.push_back({r.rk4_steps, r.leapfrog_steps, r.rk4_error, r.leapfrog_error, r.methods_apart});
    }
    /// The n-th reference, its flights left empty. Throws std::out_of_range.
    ReferenceFlight reference(std::size_t n) const {
        const Reference& r = references.at(n);
        ReferenceFlight flight;
        flight.rk4_steps = r.rk4_steps, flight.leapfrog_steps = r.leapfrog_steps;
        flight.rk4_error = r.rk4_error, flight.leapfrog_error = r.leapfrog_error;
        flight.methods_apart = r.methods_apart;
        return flight;
    }
};

}  // namespace drapeau
