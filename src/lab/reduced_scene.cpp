#include "reduced_scene.hpp"

#include "scene/file.hpp"

#include <algorithm>

namespace drapeau::lab {

namespace {

using Lines = std::vector<SceneLine>;

const SceneLine* find(const Lines& lines, const SceneLine& wanted) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const SceneLine& line) {
        return line.table == wanted.table && line.key == wanted.key;
    });
    return found == lines.end() ? nullptr : &*found;
}

std::string full_name(const SceneLine& line) {
    return line.table + (line.table.empty() ? "" : ".") + line.key;
}

/// The place in the list of what changed the line first or took it out.
std::size_t changed_by(const SceneLine& line, const std::vector<Lines>& stages) {
    for (std::size_t n = 0; n < stages.size(); ++n)
        if (const SceneLine* there = find(stages[n], line); !there || there->value != line.value) return n;
    return stages.size();
}

}  // namespace

std::string reduced_scene_text(const Scene& given, const std::vector<LeftOut>& left_out,
                               const std::vector<std::string>& heading) {
    std::vector<Lines> stages;
    for (const LeftOut& part : left_out) stages.push_back(scene_lines(part.without, true));
    std::vector<std::string> said(stages.size());  // where the remark on each stands
    std::string text = scene_heading;
    for (const std::string& line : heading) text += "# " + line + "\n";
    const Lines own = scene_lines(given);
    for (const SceneLine& line : scene_lines(given, true)) {
        if (line.key.empty()) text += "\n";
        const std::size_t by = changed_by(line, stages);
        if (by == stages.size()) {
            if (find(own, line)) text += line.text(line.comment) + "\n";
            continue;
        }
        const bool names_table = line.key.empty();
        const std::string remark = said[by].empty() ? "left out: " + left_out[by].remark : "left out with " + said[by];
        if (said[by].empty()) said[by] = names_table ? "[" + line.table + "]" : full_name(line);
        const std::string unit = line.unit.empty() ? "" : line.unit + "; ";
        text += "# " + line.text(unit + remark) + (names_table ? "  # " + remark : "") + "\n";
        if (const SceneLine* now = find(stages.back(), line)) text += now->text(now->comment) + "\n";
    }
    return text;
}

}  // namespace drapeau::lab
