// Price records: what a study of a scene's parts keeps in part files: its identity, what effects are judged by, and
// each part of the scene.
#pragma once

#include "measure/price_study.hpp"
#include "parts.hpp"
#include "price.hpp"

namespace drapeau::lab {

SweepIdentity identity_of(const PriceOptions& options, const PriceRequest& request);
/// The options that identity says. Throws InputError.
PriceOptions options_of_price(const SweepIdentity& sweep);
/// The keys of all parts, as they are dealt to shards.
std::vector<std::string> keys_of(const PriceStudy& study);

// Reading throws Json::exception or std::out_of_range for what no study wrote.
Json basis_json(const PriceStudy& study);
void restore(PriceStudy& study, const Json& basis);
Json result_json(const Priced& priced);
Json cost_json(const PartCost& cost);
/// With that of its costs which is known best: a share compares times of one machine.
Priced priced_in(const PointRecord& record, const ScenePart& part);
/// All parts of a scene, that this part file has.
Prices prices_in(const Part& part, const PriceStudy& study);

}  // namespace drapeau::lab
