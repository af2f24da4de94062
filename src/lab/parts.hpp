// Parts: what a sweep has measured, kept in files, so that one that was cut off goes on and several machines share one.
//
// A part file is text, one JSON object a line. The first says which sweep it belongs to and which share of its points
// is measured there; each line after that is a record:
//   {"basis": {...}}                              what all points are judged by
//   {"point": KEY, "cost": {...}, "result": {...}}  a point that is done; costs are times and may differ
//   {"point": KEY, "cost": {...}}                 the point timed once more
// A line without its end was cut off while it was written, and does not count.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace drapeau::lab {

using Json = nlohmann::ordered_json;

/// Every count-th point, from the place-th on.
struct Shard {
    std::size_t place = 1, count = 1;

    bool is_whole() const { return count == 1; }
    /// Those of so many points that it takes.
    std::vector<std::size_t> places(std::size_t points) const {
        std::vector<std::size_t> all;
        for (std::size_t n = place - 1; n < points; n += count) all.push_back(n);
        return all;
    }
    std::string text() const { return std::to_string(place) + "/" + std::to_string(count); }
    bool operator==(const Shard&) const = default;
};

/// "2/8"; "" is the whole. Throws InputError.
Shard shard_in(const std::string& option, const std::string& text);

/// What the parts of one sweep have in common: all that its results follow from.
struct SweepIdentity {
    std::string command;
    std::string version;  // of the program
    std::string scene;    // as write_scene writes it
    Json options;         // what other options say, by their names: texts, or true and false
};

/// An option whose text belongs to the identity.
template <class Options>
struct TextOption {
    const char* name;
    std::string Options::*text;
};

template <class Options>
Json texts_json(const Options& options, std::span<const TextOption<Options>> texts) {
    Json json = Json::object();
    for (const TextOption<Options>& option : texts) json[option.name] = options.*option.text;
    return json;
}
/// Throws Json::exception.
template <class Options>
void read_texts(const Json& json, Options& options, std::span<const TextOption<Options>> texts) {
    for (const TextOption<Options>& option : texts)
        options.*option.text = json.at(option.name).template get<std::string>();
}

/// Calls read(options) of what a sweep's identity says. Throws InputError where that throws, as other options do.
void use_options(const SweepIdentity& sweep, const std::function<void(const Json&)>& read);

/// The first thing in which two differ, as a person would say it: "--settle is 1 there and 2 here". Nothing if they are
/// of one sweep.
std::optional<std::string> difference(const SweepIdentity& there, const SweepIdentity& here);

/// A line of a part file.
struct RecordPlace {
    std::string file{};
    std::size_t line = 0;
};

struct CostRecord {
    Json cost;
    RecordPlace place{};
};

struct PointRecord {
    Json result;
    std::vector<CostRecord> costs;
    RecordPlace place{};
};

struct Part {
    std::string file;
    SweepIdentity sweep;
    Shard shard;
    Json machine;  // what measured it
    Json basis;    // null until it is known
    RecordPlace basis_place;
    std::map<std::string, PointRecord> points;  // by their keys
    std::size_t whole_bytes = 0;                // of the lines that count
};

/// Calls read(point). Throws InputError that names file and line where that throws, as records of the wrong form do.
void use_point(const Part& part, const std::string& key, const std::function<void(const PointRecord&)>& read);
/// The same of each of its costs, whose lines are named.
void use_costs(const PointRecord& point, const std::function<void(const Json&)>& read);
/// The same of what points are judged by.
void use_basis(const Part& part, const std::function<void(const Json&)>& read);

/// Throws InputError that names file, line and fault.
Part read_part(const std::string& file);

/// The first line of a part and records, each with its end.
std::string header_line(const SweepIdentity& sweep, const Shard& shard);
std::string basis_line(const Json& basis);
std::string point_line(const std::string& key, const Json& cost, const Json& result = nullptr);

/// Parts of one sweep.
struct Joined {
    std::vector<Part> parts;
    Part all;            // of all of them: points with the costs of each
    std::string remark;  // what whoever compares costs should know; "" is nothing

    /// The points, of these keys in the order in which shards take them, that no part has: which, and how to make them.
    /// Nothing if none is missing.
    std::optional<std::string> missing(const std::vector<std::string>& keys) const;
};

/// "AMD EPYC 7763 64-Core Processor"
std::string processor_name();

/// Throws InputError that names the parts that do not belong together, and why.
Joined join(const std::vector<std::string>& files);

}  // namespace drapeau::lab
