// Converge sweep: steps, then grids, within a budget. It prints nothing; who asks is told how far it is.
#pragma once

#include "grid_convergence.hpp"
#include "step_convergence.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drapeau::lab {

struct ConvergeRequest {
    Scene scene;
    std::vector<Method> methods;
    std::vector<std::pair<int, int>> grids;
    double settle = 0.0;             // s
    long long batches = 30;          // of 1/60 s, compared
    bool batches_are_given = false;  // else fewer where the motion is chaotic
    double budget = 120.0;           // s of time on the wall
};

struct ConvergeFindings {
    std::optional<std::string> diverged;  // how, while it swung in
    double seconds = 0.0;                 // compared
    bool is_shortened = false;            // for the motion is chaotic
    Growth growth;                        // on the scene's own grid
    ReferenceFlight reference;            // there
    std::vector<MethodConvergence> steps;
    GridConvergence grids;

    double horizon() const { return growth.horizon(1e-3); }  // s
};

class ConvergeSweep {
public:
    /// Finds out how fast this machine is. Throws InputError where no mass is free, or the budget does not even suffice
    /// for the reference.
    explicit ConvergeSweep(const ConvergeRequest& request);

    double estimate() const;  // s of time on the wall, at most the budget
    ConvergeFindings find(const std::function<void(double)>& tick);

private:
    double elapsed() const;
    double left() const { return request_.budget - elapsed(); }
    double least_of_reference() const;
    GridRequest grid_request() const;
    StepGround ground_of(const Stretch& stretch, Yardstick& yardstick, const ConvergeFindings& found) const;
    std::vector<MethodConvergence> all_methods(const StepGround& ground) const;

    ConvergeRequest request_;
    Model model_;
    double unit_ = 0.0;  // s, what one unit of step_cost takes in double
    double began_ = 0.0;
};

}  // namespace drapeau::lab
