// Trade outcome: what follows from the points of a sweep, said in tables, kept in files, and as an exit status.
#pragma once

#include "trade_report.hpp"

#include "io/output_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace drapeau::lab {

struct TradeOutputs {
    std::string json, write, plot;     // "" writes none
    std::filesystem::path scene_file;  // beside which the scene's image is; "" where that is not known

    std::vector<NamedFile> files() const;
};

/// The front, orders and the setting to recommend, for which the sweep must have been prepared.
TradeFindings findings_of(const TradeSweep& sweep, std::vector<Measured> points, const Tick& tick);

/// Prints and writes all of it; the exit status.
int report(const TradeSweep& sweep, const TradeFindings& findings, const TradeOutputs& outputs);

}  // namespace drapeau::lab
