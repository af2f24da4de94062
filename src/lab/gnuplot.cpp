#include "gnuplot.hpp"

#include "child.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/output_file.hpp"
#include "io/text.hpp"

#include <iterator>
#include <utility>

namespace drapeau::lab {

namespace {

/// Runs gnuplot on a script: what it draws, and what it complains of, "" if it ends well.
struct Drawn {
    std::string picture, complaint;
};

Drawn drawn_by_gnuplot(const std::string& script) {
    Said gnuplot;
    try {
        gnuplot = run_child("--plot", {"gnuplot", "-d", "-"}, script);  // without the user's own settings
    } catch (const InputError& missing) {
        throw InputError(std::string(missing.what()) + " (Debian's package is gnuplot-nox)");
    }
    if (gnuplot.status == 0) return {std::move(gnuplot.output), ""};
    std::string said;  // gnuplot shows the line and a caret before it says what is wrong
    for (std::string left = gnuplot.complaints; !left.empty();) {
        const auto end = left.find('\n');
        const std::string line(without_space(std::string_view(left).substr(0, end)));
        if (!line.empty() && line != "^") said = line;
        left = end == std::string::npos ? "" : left.substr(end + 1);
    }
    return {"", said.empty() ? "it ended badly" : one_line(said, 300)};
}

/// Twice as many pixels as an SVG has units.
std::string terminal_of(const std::string& ending) {
    const std::string font = "enhanced font 'DejaVu Sans,13'";
    return ending == ".svg"
               ? "set terminal svg size 960,640 background '#ffffff' " + font + "\n"
               : "set terminal pngcairo size 1920,1280 fontscale 2 pointscale 2 linewidth 2 " + font + "\n";
}

}  // namespace

void check_plot(const std::string& option, const std::string& file) {
    if (file.empty()) return;
    const std::string ending = ending_of(file);
    if (ending != ".svg" && ending != ".png")
        throw InputError(option + " = " + one_line(file, 1000) +
                         ": .svg or .png is allowed, the ending chooses the format");
    if (const std::string complaint = drawn_by_gnuplot(terminal_of(ending)).complaint; !complaint.empty())
        throw InputError(option + ": gnuplot cannot make " + ending + " files: " + complaint);
}

void plot(const std::string& file, const std::string& script) {
    const Drawn drawn =
        drawn_by_gnuplot("set encoding utf8\nset micro\n" + terminal_of(ending_of(file)) + script + "\nunset output\n");
    if (drawn.picture.empty())
        throw InputError("--plot = " + one_line(file, 1000) + ": gnuplot could not make it" +
                         (drawn.complaint.empty() ? "" : ": " + drawn.complaint));
    write_file(file, [&](const Append& append) { append(drawn.picture); });
}

std::string plot_text(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "''" : c == '\n' ? "'.\"\\n\".'" : std::string(1, c);
    return quoted + "'";
}

std::string plot_number(double value) {
    return shortest(value);
}

MethodStyle style_of(Method method) {
    constexpr MethodStyle styles[] = {{"#E69F00", 5, 4},   {"#0072B2", 7, 6},   {"#D55E00", 9, 8},
                                      {"#009E73", 13, 12}, {"#CC79A7", 11, 10}, {"#56B4E9", 15, 14}};
    return styles[static_cast<std::size_t>(method) % std::size(styles)];
}

}  // namespace drapeau::lab
