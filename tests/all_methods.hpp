// Every method of the list, for laws that hold for all of them.
#pragma once

#include "drapeau/methods/list.hpp"

#include <vector>

namespace drapeau {

inline std::vector<Method> all_methods() {
    std::vector<Method> all;
    for (std::size_t n = 0; n < method_count; ++n) all.push_back(static_cast<Method>(n));
    return all;
}

}  // namespace drapeau
