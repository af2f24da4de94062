// Evaluation: one pass that stores the acceleration of every mass and moves nothing, given to a kernel directly.
#pragma once

#include "drapeau/model_rows.hpp"
#include "drapeau/sweep.hpp"

#include <utility>
#include <vector>

namespace drapeau::bench {
inline namespace DRAPEAU_ISA {

template <class Real>
class Evaluation {
public:
    Evaluation(const Model& model, const Kernels<Real>& kernels, const State<double>& state, double dt)
        : kernels_(kernels),
          rows_(model),
          waiting_(rows_.width()),
          pushed_(state.columns(), 1),
          out_(state.columns(), state.rows()) {
        for (int f = 0; f < kernels.fields; ++f) fields_.emplace_back(state.columns(), state.rows(), f);
        for (const int f : {0, kernels.seen_position}) fields_[f].take(state.position);
        for (const int f : {1, kernels.seen_velocity}) fields_[f].take(state.velocity);
        for (int f = 0; f < kernels.fields; ++f) pass_.fields[f] = fields_[f].view();
        pass_.last = pass_.rows = state.rows();
        pass_.width = rows_.width();
        pass_.constants = rows_.constants();
        pass_.acceleration = std::as_const(pushed_).view();
        pass_.acceleration.stride = 0;  // one row for all
        pass_.dt = static_cast<Real>(dt);
        pass_.waiting = waiting_.view();
        pass_.out = out_.view();
    }
    Evaluation(const Evaluation&) = delete;

    void run() { kernels_.evaluate(pass_); }
    const FieldBuffer<Real>& result() const { return out_; }  // m/s2, but for drag and friction

private:
    Kernels<Real> kernels_;
    ModelRows<Real> rows_;
    WaitingBuffer<Real> waiting_;
    FieldBuffer<Real> pushed_, out_;
    std::vector<FieldBuffer<Real>> fields_;
    Pass<Real> pass_{};
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau::bench
