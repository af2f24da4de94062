#include "report.hpp"

#include "child.hpp"
#include "exit_status.hpp"
#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/output_file.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "kernels/kernels.hpp"
#include "lists.hpp"
#include "parts.hpp"
#include "program.hpp"
#include "progress.hpp"
#include "report_answers.hpp"
#include "report_page.hpp"
#include "scene/file.hpp"
#include "shared_options.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <thread>

namespace drapeau::lab {

namespace {

namespace fs = std::filesystem;

/// A folder for what commands write, which goes with all that is in it.
class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "drapeau-report-XXXXXX").string();
        if (!mkdtemp(name.data())) throw InputError("--output: no folder for what is to stand on the page: " + name);
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
    fs::path path_;
};

/// One of the commands, and its share of the time.
struct Chapter {
    const char* command;
    const char* title;
    const char* question;
    double share;  // of the budget; 0: it takes none
    bool to_tolerance;
    std::vector<std::string> (*answers)(const Json&, const Scene&);
};

constexpr Chapter chapters[] = {
    {"trade", "Speed against accuracy", "What does every method, step and precision cost, and how wrong is it?", 0.35,
     true, trade_answers},
    {"stability", "The limit of stability", "How large may a step be, over stiffness and damping?", 0.0, false,
     stability_answers},
    {"price", "What each part costs and matters", "Which parts of the scene could be left out?", 0.3, true,
     price_answers},
    {"converge", "Smaller steps and finer grids", "Do they lead anywhere, and how fast?", 0.35, false,
     converge_answers},
};

/// The last line that is no progress, without the program's name.
std::string last_word(const std::string& complaints) {
    const std::string start = std::string(program) + ": ";
    std::string last;
    for (std::string left = complaints; !left.empty();) {
        const auto end = left.find('\n');
        std::string line = left.substr(0, end);
        if (line.starts_with(start)) line = line.substr(start.size());
        if (!line.empty()) last = line;
        left = end == std::string::npos ? "" : left.substr(end + 1);
    }
    return last;
}

std::string as_typed(const std::vector<std::string>& words) {
    std::string typed = program;
    for (const std::string& word : words) {
        const bool is_plain = word.find_first_of(" '\"[]$&|;<>*?()") == std::string::npos && !word.empty();
        typed += " " + (is_plain ? word : "'" + word + "'");
    }
    return typed;
}

/// Runs the command; its tables, picture and answers go to the page. Whether it measured something.
bool add_chapter(const Chapter& chapter, const ReportOptions& options, const Scene& scene, double budget,
                 const Folder& folder, ReportPage& page) {
    std::vector<std::string> words{chapter.command, options.scene};
    for (const std::string& assignment : options.set) words.insert(words.end(), {"--set", assignment});
    if (chapter.share > 0.0) words.insert(words.end(), {"--budget", rounded(chapter.share * budget / 60.0, 3)});
    if (chapter.to_tolerance) words.insert(words.end(), {"--tolerance", options.tolerance});
    ReportSection section{chapter.title, chapter.question, as_typed(words), "", "", ""};

    const std::string json = folder.file(std::string(chapter.command) + ".json");
    const std::string picture = folder.file(std::string(chapter.command) + ".svg");
    words.insert(words.begin(), "/proc/self/exe");
    words.insert(words.end(), {"--json", json, "--plot", picture});
    const Said said = run_child("report", words, "");
    section.text = said.output;
    const bool is_measured = said.status == exit_good || said.status == exit_not_met;
    if (!is_measured) section.trouble = last_word(said.complaints);
    if (fs::exists(json)) {
        const Json found = Json::parse(read_text_file(json, std::size_t{1} << 28), nullptr, false);
        for (const std::string& answer : chapter.answers(found, scene)) page.answers.push_back(answer);
    }
    if (fs::exists(picture)) section.picture = read_text_file(picture, std::size_t{1} << 28);
    page.sections.push_back(std::move(section));
    return is_measured;
}

std::vector<std::string> machine_lines() {
    return {
        processor_name() + ", " + std::to_string(std::thread::hardware_concurrency()) + " processors; costs are of one",
        "instruction set of the kernels: " + kernel_target(), "drapeau-lab " DRAPEAU_VERSION};
}

}  // namespace

int report(const ReportOptions& options) {
    if (options.output.empty()) throw InputError("--output: give the page a name, such as report.html");
    if (ending_of(options.output) != ".html")
        throw InputError("--output = " + one_line(options.output, 1000) + ": .html is allowed");
    const double budget = budget_option(options.budget);
    distance_in("--tolerance", options.tolerance);
    const Scene scene = scene_in(options.scene, options.set);
    const fs::path file = find_scene(options.scene);
    check_outputs({{"the scene", file.string()}}, {{"--output", options.output}});
    check_plot("report", "report.svg");

    ReportPage page;
    page.scene = scene.name;
    page.settings = write_scene(scene);
    page.machine = machine_lines();
    const Folder folder;
    std::string trouble;
    bool is_measured = false;
    for (const Chapter& chapter : chapters) {
        complain(program, fmt::format("{} of {}: {}{}", page.sections.size() + 1, std::size(chapters), chapter.command,
                                      chapter.share > 0.0 ? ", at most " + duration(chapter.share * budget) : ""));
        is_measured = add_chapter(chapter, options, scene, budget, folder, page) || is_measured;
        if (trouble.empty()) trouble = page.sections.back().trouble;
    }
    if (!is_measured) throw InputError(trouble);
    write_text_file(options.output, [&](const Append& append) { append(html_of(page)); });
    return exit_good;
}

}  // namespace drapeau::lab
