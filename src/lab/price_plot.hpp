// Price plot: bars of what each part of a scene costs and what leaving it out changes, as a script of gnuplot.
#pragma once

#include "measure/price_study.hpp"

#include <string>

namespace drapeau::lab {

std::string price_script(const PriceStudy& study, const Prices& prices);

}  // namespace drapeau::lab
