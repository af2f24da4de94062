// drapeau-lab price: what each part of a scene costs in time and what leaving it out changes, and the smallest scene
// that stays within a tolerance.
#pragma once

#include "comparison_options.hpp"

#include <string>

namespace drapeau::lab {

struct PriceOptions : ComparisonOptions {
    std::string write;  // files to write; "" writes none
    std::string json;
    std::string plot;  // a picture, .svg or .png; "" draws none
};

/// The exit status: good, not met or diverged. Throws InputError for bad input, before anything is computed or written.
int price(const PriceOptions& options);

}  // namespace drapeau::lab
