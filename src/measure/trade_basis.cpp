// What a sweep's points are judged by, taken out of it and put into another that is to be reported.
#include "measure/trade_sweep.hpp"

#include <utility>

namespace drapeau {

Basis TradeSweep::basis() const {
    const Stretch& stretch = grounds_.front().stretch;
    Basis basis{stretch.time, stretch.batches, is_shortened_, growth_, reference_tip_, {}};
    for (const Footing& ground : grounds_) basis.add(ground.reference);
    return basis;
}

void TradeSweep::restore(const Basis& basis) {
    request_.batches = basis.batches;
    is_shortened_ = basis.is_shortened;
    growth_ = basis.growth;
    reference_tip_ = basis.tip;
    grounds_.clear();
    for (std::size_t n = 0; n < variants_.size(); ++n)
        grounds_.push_back({variants_[n],
                            models_[n],
                            {State<double>(1, 1), basis.time, basis.batches, 1},
                            basis.reference(n),
                            nullptr});
    list_affordable();
}

}  // namespace drapeau
