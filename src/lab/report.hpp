// drapeau-lab report: what trade, stability, price and converge find about a scene, as one page that needs nothing
// else.
#pragma once

#include <string>
#include <vector>

namespace drapeau::lab {

struct ReportOptions {
    std::string scene;             // a path or the name of a shipped scene
    std::vector<std::string> set;  // "KEY=VALUE", instead of what the scene says
    std::string output;            // the page, .html
    std::string tolerance = "1mm";
    std::string budget = "8";  // minutes, of all of it
};

/// The exit status. Throws InputError for bad input, before anything is computed or written.
int report(const ReportOptions& options);

}  // namespace drapeau::lab
