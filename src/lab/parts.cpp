#include "parts.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "kernels/kernels.hpp"
#include "lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace drapeau::lab {

namespace {

constexpr const char* format_name = "drapeau-lab part";  // the first key of the first line
constexpr int format_version = 1;
constexpr std::size_t most_bytes = std::size_t{1} << 30;

[[noreturn]] void fail(const std::string& file, const std::string& why) {
    throw InputError(one_line(file, 1000) + ": " + why);
}
[[noreturn]] void fail_in(const std::string& file, std::size_t line, const std::string& why) {
    fail(file, "line " + std::to_string(line) + ": " + why);
}

void read_header(Part& part, const std::string& line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains(format_name)) fail(part.file, "no part of a sweep, such as --part writes");
    if (json.at(format_name) != format_version)
        fail(part.file, "a part in another form, of another version of drapeau-lab");
    try {
        part.sweep = {json.at("command"), json.at("version"), json.at("scene"), json.at("options")};
        part.shard = shard_in("shard", json.at("shard"));
        part.machine = json.at("machine");
    } catch (const Json::exception&) {
        fail_in(part.file, 1, "it does not say which sweep this is of");
    }
}

void read_record(Part& part, const std::string& line, std::size_t number) {
    const Json json = Json::parse(line, nullptr, false);
    const bool is_basis = json.is_object() && json.contains("basis");
    const bool is_point = json.is_object() && json.contains("point") && json["point"].is_string();
    if (is_basis) {
        part.basis = json["basis"];
        part.basis_place = {part.file, number};
        return;
    }
    if (!is_point) fail_in(part.file, number, "no record of a sweep");
    const std::string key = json["point"];
    const bool is_new = !part.points.contains(key), has_result = json.contains("result");
    if (is_new && !has_result) fail_in(part.file, number, "a cost of a point that is not done, " + in_quotes(key));
    if (!is_new && has_result) fail_in(part.file, number, "a point that is done already, " + in_quotes(key));
    PointRecord& point = part.points[key];
    if (has_result) point = {json["result"], {}, {part.file, number}};
    if (json.contains("cost")) point.costs.push_back({json["cost"], {part.file, number}});
}

/// Calls read(); where that throws, as records of the wrong form make it, the line is at fault.
template <class Read>
void read_in(const RecordPlace& place, const std::string& fault, const Read& read) {
    try {
        read();
    } catch (const Json::exception&) {
        fail_in(place.file, place.line, fault);
    } catch (const std::out_of_range&) {
        fail_in(place.file, place.line, fault);
    }
}

std::string named(const Part& part) {
    return one_line(part.file, 1000);
}

/// The first line in which two texts differ, without the comment behind it.
std::pair<std::string, std::string> first_difference(const std::string& one, const std::string& other) {
    std::istringstream ones(one), others(other);
    for (std::string a, b; true;) {
        if (!std::getline(ones, a)) a = "nothing";
        if (!std::getline(others, b)) b = "nothing";
        if (a == b && !ones && !others) return {};
        if (a == b) continue;
        const auto bare = [](const std::string& line) {
            return one_line(without_space(std::string_view(line).substr(0, line.find("  #"))), 60);
        };
        return {bare(a), bare(b)};
    }
}

std::string text_of(const Json& value) {
    if (!value.is_string()) return one_line(value.dump(), 60);
    return value == "" ? "not given" : one_line(value.get<std::string>(), 60);
}

/// "; shards 2/8, 3/8 and 4 more are not among the parts", or nothing.
std::string absent_text(const std::vector<std::string>& shards) {
    constexpr std::size_t named_at_most = 8;
    if (shards.empty()) return "";
    if (shards.size() == 1) return "; shard " + shards.front() + " is not among the parts";
    const std::size_t listed = std::min(shards.size(), named_at_most);
    std::string text = "; shards " + shards.front();
    for (std::size_t n = 1; n < listed; ++n) text += (n + 1 == shards.size() ? " and " : ", ") + shards[n];
    if (listed < shards.size()) text += fmt::format(" and {} more", shards.size() - listed);
    return text + " are not among the parts";
}

/// Takes the points of one more part into all of them.
void take(Part& all, const Part& part) {
    for (const auto& [key, point] : part.points) {
        const auto [known, is_new] = all.points.try_emplace(key, point);
        if (is_new) continue;
        if (known->second.result != point.result)
            fail_in(point.place.file, point.place.line,
                    "another result for " + in_quotes(key) + " than in the parts before");
        known->second.costs.insert(known->second.costs.end(), point.costs.begin(), point.costs.end());
    }
}

}  // namespace

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    return "unknown";
}

Shard shard_in(const std::string& option, const std::string& text) {
    constexpr std::size_t most = 1'000'000;
    if (text.empty()) return {};
    const auto slash = text.find('/');
    const auto whole = [](const std::string& digits) -> std::size_t {
        const bool is_whole =
            !digits.empty() && digits.size() < 8 && digits.find_first_not_of("0123456789") == std::string::npos;
        return is_whole ? std::stoul(digits) : 0;
    };
    const Shard shard{whole(text.substr(0, slash)), slash == std::string::npos ? 0 : whole(text.substr(slash + 1))};
    if (shard.place >= 1 && shard.place <= shard.count && shard.count <= most) return shard;
    refuse(option, text, "I/N, the I-th of N shards, such as 2/8,");
}

std::optional<std::string> difference(const SweepIdentity& there, const SweepIdentity& here) {
    const auto differs = [](const std::string& what, const std::string& one, const std::string& other) {
        return what + " is " + one + " there and " + other + " here";
    };
    if (there.command != here.command) return differs("the command", one_line(there.command), one_line(here.command));
    if (there.version != here.version)
        return differs("the version of drapeau-lab", one_line(there.version), one_line(here.version));
    if (there.scene != here.scene) {
        const auto [one, other] = first_difference(there.scene, here.scene);
        return differs("the scene's setting", one, other);
    }
    for (const auto& [name, value] : here.options.items())
        if (!there.options.contains(name) || there.options[name] != value)
            return differs(name, there.options.contains(name) ? text_of(there.options[name]) : "unknown",
                           text_of(value));
    if (there.options.size() != here.options.size()) return "there are options that are unknown here";
    return {};
}

void use_options(const SweepIdentity& sweep, const std::function<void(const Json&)>& read) {
    try {
        read(sweep.options);
    } catch (const Json::exception&) {
        throw InputError("the parts do not say with which options their sweep was made");
    }
}

void use_point(const Part& part, const std::string& key, const std::function<void(const PointRecord&)>& read) {
    const PointRecord& point = part.points.at(key);
    read_in(point.place, "no result of this sweep", [&] { read(point); });
}

void use_costs(const PointRecord& point, const std::function<void(const Json&)>& read) {
    for (const CostRecord& record : point.costs)
        read_in(record.place, "no cost of this sweep", [&] { read(record.cost); });
}

void use_basis(const Part& part, const std::function<void(const Json&)>& read) {
    if (part.basis.is_null()) fail(part.file, "it does not say yet what points are judged by");
    read_in(part.basis_place, "what it says points are judged by is nothing of this sweep", [&] { read(part.basis); });
}

Part read_part(const std::string& file) {
    Part part;
    part.file = file;
    const std::string bytes = read_text_file(file, most_bytes);
    if (bytes.empty()) fail(file, "empty, no part of a sweep");
    std::size_t number = 0;
    for (std::size_t from = 0; from < bytes.size();) {
        const std::size_t end = bytes.find('\n', from);
        if (end == std::string::npos) break;
        const std::string line = bytes.substr(from, end - from);
        ++number == 1 ? read_header(part, line) : read_record(part, line, number);
        from = part.whole_bytes = end + 1;
    }
    if (number == 0) read_header(part, bytes);
    return part;
}

std::string header_line(const SweepIdentity& sweep, const Shard& shard) {
    const Json json{{format_name, format_version},
                    {"command", sweep.command},
                    {"version", sweep.version},
                    {"shard", shard.text()},
                    {"options", sweep.options},
                    {"scene", sweep.scene},
                    {"machine", {{"processor", processor_name()}, {"instruction_set", kernel_target()}}}};
    return json.dump() + "\n";
}

std::string basis_line(const Json& basis) {
    return Json{{"basis", basis}}.dump() + "\n";
}

std::string point_line(const std::string& key, const Json& cost, const Json& result) {
    Json json{{"point", key}};
    if (!cost.is_null()) json["cost"] = cost;
    if (!result.is_null()) json["result"] = result;
    return json.dump() + "\n";
}

std::optional<std::string> Joined::missing(const std::vector<std::string>& keys) const {
    std::size_t count = 0;
    const std::string* first = nullptr;
    std::map<std::size_t, std::size_t> of_shard;  // place, how many
    const std::size_t shards = parts.front().shard.count;
    for (std::size_t n = 0; n < keys.size(); ++n) {
        if (all.points.contains(keys[n])) continue;
        if (count++ == 0) first = &keys[n];
        ++of_shard[n % shards + 1];
    }
    if (count == 0) return {};
    std::vector<std::string> absent;
    std::string unfinished;
    for (const auto& [place, of_it] : of_shard) {
        const Shard shard{place, shards};
        const auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& one) { return one.shard == shard; });
        if (part == parts.end())
            absent.push_back(shard.text());
        else
            unfinished += fmt::format("; shard {} lacks {}, its command with --resume goes on with {}", shard.text(),
                                      of_it, named(*part));
    }
    return fmt::format("{} of {} {} missing, {} for one{}{}", count, counted(keys.size(), "point"),
                       count == 1 ? "is" : "are", in_quotes(*first), absent_text(absent), unfinished);
}

Joined join(const std::vector<std::string>& files) {
    Joined joined;
    for (const std::string& file : files) joined.parts.push_back(read_part(file));
    const Part& first = joined.parts.front();
    joined.all.file = first.file;
    joined.all.sweep = first.sweep;
    for (const Part& part : joined.parts) {
        const auto refused = [&](const std::string& why) {
            fail(part.file, "of another sweep than " + named(first) + ": " + why);
        };
        if (const auto what = difference(first.sweep, part.sweep)) refused(*what);
        if (part.shard.count != first.shard.count && !part.shard.is_whole() && !first.shard.is_whole())
            refused(fmt::format("it is shard {}, and shard {} there", part.shard.text(), first.shard.text()));
        if (part.machine != first.machine)
            joined.remark = "costs were measured on different processors: compare them with care";
        take(joined.all, part);
        Json& basis = joined.all.basis;
        if (basis.is_null()) basis = part.basis, joined.all.basis_place = part.basis_place;
        if (basis == part.basis || part.basis.is_null()) continue;
        if (part.machine == first.machine)
            refused("on the same processor its reference came out otherwise: it was made by another build");
        joined.remark =
            "the parts were computed on different processors, whose rounding differs; the reference is that of " +
            named(first);
    }
    return joined;
}

}  // namespace drapeau::lab
