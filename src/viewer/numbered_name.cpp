#include "numbered_name.hpp"

#include "io/error.hpp"
#include "io/text.hpp"

#include <optional>
#include <string>

namespace drapeau {

namespace {

struct Place {
    std::size_t begin = 0, length = 0;  // of "%04d" in the name
    std::size_t digits = 1;             // at least
};

std::optional<Place> place_in(const std::string& name) {
    const auto begin = name.find('%');
    if (begin == std::string::npos || name.find('%', begin + 1) != std::string::npos) return {};
    const std::string rest = name.substr(begin + 1, 3);
    if (rest.starts_with("d")) return Place{.begin = begin, .length = 2};
    if (rest.size() < 3 || rest[0] != '0' || rest[1] < '1' || rest[1] > '9' || rest[2] != 'd') return {};
    return Place{.begin = begin, .length = 4, .digits = std::size_t(rest[1] - '0')};
}

}  // namespace

bool means_sequence(const std::filesystem::path& name) {
    return name.filename().string().find('%') != std::string::npos;
}

void check_numbered(const std::filesystem::path& name) {
    if (place_in(name.filename().string())) return;
    throw InputError(one_line(name.string(), 1000) +
                     ": a sequence of files is named with one place for their number, such as %04d");
}

std::filesystem::path numbered(const std::filesystem::path& name, long long number) {
    std::string file = name.filename().string(), digits = std::to_string(number);
    const Place place = place_in(file).value();
    if (digits.size() < place.digits) digits.insert(0, place.digits - digits.size(), '0');
    file.replace(place.begin, place.length, digits);
    return name.parent_path() / file;
}

}  // namespace drapeau
