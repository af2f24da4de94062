// Converge plot: how differences shrink with the step and with the cells, as a script of gnuplot.
#pragma once

#include "converge_sweep.hpp"

#include <string>

namespace drapeau::lab {

std::string converge_script(const ConvergeRequest& request, const ConvergeFindings& found);

}  // namespace drapeau::lab
