// Converge sweep: steps, then grids, within a budget. It prints nothing; who asks is told how far it is.
#pragma once

#include "grid_convergence.hpp"
#include "measure/basis.hpp"
#include "measure/comparison_request.hpp"
#include "step_convergence.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drapeau::lab {

struct ConvergeRequest : ComparisonRequest {
    std::vector<Method> methods;
    std::vector<std::pair<int, int>> grids;
};

struct ConvergeFindings {
    double seconds = 0.0;       // compared
    bool is_shortened = false;  // for the motion is chaotic
    Growth growth;              // on the scene's own grid
    ReferenceFlight reference;  // there
    std::vector<MethodConvergence> steps;
    GridConvergence grids;

    double horizon() const { return growth.horizon(1e-3); }  // s
    bool is_beyond_horizon() const { return horizon() < seconds; }
};

/// What can be measured by itself: a method's steps, a grid, or a grid once more with light borders.
struct ConvergePoint {
    enum class Kind { steps, grid, light_borders };

    Kind kind = Kind::steps;
    std::size_t place = 0;  // of the method, or of the grid
    std::string key;        // stable: "rk4", "grid 45x30", "light borders 45x30"
};

class ConvergeSweep {
public:
    /// Finds out how fast this machine is. Throws InputError where no mass is free, or the budget does not even suffice
    /// for the reference.
    explicit ConvergeSweep(const ConvergeRequest& request);

    const ConvergeRequest& request() const { return request_; }
    double estimate() const;  // s of time on the wall, of everything

    /// Lets the scene swing in and flies its reference. Returns how it diverged, if it did.
    std::optional<std::string> prepare(const std::function<void()>& tick);
    /// s on the wall since the sweep was made.
    double elapsed() const;

    /// All methods, then all grids, while the budget lasts.
    ConvergeFindings measure(const std::function<void()>& tick);

    // Where work is counted, each by itself. Methods share their part of the budget evenly.
    std::vector<ConvergePoint> points() const;
    MethodConvergence steps_of(Method method, const std::function<void()>& tick);
    /// For functions of grids.
    GridRequest grid_request(double seconds) const;
    GridRequest counted_grid_request() const;

    /// What prepare() found; and the same taken from elsewhere, for a report.
    Basis basis() const;
    void restore(const Basis& basis);
    const ConvergeFindings& found() const { return found_; }

private:
    double left() const { return request_.budget - elapsed(); }
    double least_of_reference() const;
    StepGround ground(const std::function<void()>& tick);
    std::vector<MethodConvergence> all_methods(const StepGround& ground) const;

    ConvergeRequest request_;
    Model model_;
    double unit_ = 0.0;  // s, what one unit of step_cost takes in double, or counts for
    double pace_ = 1.0;  // s here for a s as work is counted
    double began_ = 0.0;
    Stretch stretch_;
    Yardstick yardstick_;
    ConvergeFindings found_;
};

}  // namespace drapeau::lab
