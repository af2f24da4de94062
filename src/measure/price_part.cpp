#include "measure/price_part.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/same_cloth.hpp"
#include "scene/check.hpp"
#include "scene/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

namespace drapeau {

namespace {

using namespace settings;

/// Takes a term or limit out by its table; false if the scene lists none of that name.
bool take_out(Scene& scene, const std::string& wanted) {
    bool found = false;
    each_table(scene, [&](const std::string& table, auto& settings, const auto&) {
        if constexpr (requires { settings.reset(); }) {
            if (table != wanted || !settings) return;
            settings.reset();
            found = true;
        }
    });
    return found;
}

/// The part, with whatever would be a fault without it left out as well.
ScenePart part_of(const std::string& key, const std::string& label, const Scene& without) {
    ScenePart part{key, label, without, {}, ""};
    while (const auto fault = find_fault(part.without)) {
        if (!take_out(part.without, fault->table)) {
            part.impossible = fault->text();
            break;
        }
        part.also.push_back(fault->table);
        part.label += ", and the " + fault->table + " that needs it";
    }
    return part;
}

template <class Value>
std::string with_value(const std::string& name, const Value& value, const About& about) {
    return name + " = " + value_text(value) + (about.unit.empty() ? "" : " " + std::string(about.unit));
}

/// How many vectors of a table are not zero. The last one stands for its term.
template <class Settings, class Keys>
int count_of_vectors(const Settings& settings, const Keys& keys) {
    int count = 0;
    each_key(keys, [&](const auto& field) {
        if constexpr (std::is_same_v<std::decay_t<decltype(settings.*field.member)>, glm::dvec3>)
            count += settings.*field.member != glm::dvec3(0.0);
    });
    return count;
}

class Listing {
public:
    explicit Listing(const Scene& scene) : scene_(scene) {}

    std::vector<ScenePart> all() {
        Scene rest = scene_;
        each_table(rest, [&](const std::string& table, auto& settings, const auto& keys) {
            using Listed = std::decay_t<decltype(settings)>;
            if constexpr (std::is_same_v<Listed, std::optional<SpringSettings>> ||
                          std::is_same_v<Listed, std::optional<Fabric>>) {  // there is no scene without its material
                if (settings) optional_settings(table, *settings, keys, rest);
            } else if constexpr (requires { settings.reset(); }) {
                if (!settings) return;
                whole(table, settings, rest);
                optional_settings(table, *settings, keys, rest);
                strengths(table, *settings, keys, rest);
            }
        });
        precision();
        tolerance();
        grid();
        return std::move(parts_);
    }

private:
    // Each of these changes the scene, adds it as what is left, and puts back what it changed.

    template <class Listed>
    void whole(const std::string& table, Listed& listed, Scene& rest) {
        const Listed kept = listed;
        listed.reset();
        parts_.push_back(part_of(table, table, rest));
        listed = kept;
    }

    template <class Settings, class Keys>
    void optional_settings(const std::string& table, Settings& settings, const Keys& keys, Scene& rest) {
        each_key(keys, [&](const auto& field) {
            auto& value = settings.*field.member;
            if constexpr (requires { value.reset(); }) {
                if (!value) return;
                const auto kept = value;
                const std::string key = full_name(table, field.key);
                value.reset();
                parts_.push_back(part_of(key, with_value(key, *kept, field.about), rest));
                value = kept;
            }
        });
    }

    template <class Settings, class Keys>
    void strengths(const std::string& table, Settings& settings, const Keys& keys, Scene& rest) {
        const bool several = count_of_vectors(settings, keys) > 1;
        each_key(keys, [&](const auto& field) {
            auto& value = settings.*field.member;
            using Value = std::decay_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, glm::dvec3>) {
                constexpr bool is_vector = std::is_same_v<Value, glm::dvec3>;
                const Value none{};
                if (value == none || (is_vector && !several)) return;
                const Value kept = value;
                const std::string key = full_name(table, field.key);
                value = none;
                parts_.push_back(part_of(key, with_value(key, kept, field.about), rest));
                value = kept;
            }
        });
    }

    void precision() {
        if (scene_.time.precision != Precision::double_precision) return;
        Scene rest = scene_;
        rest.time.precision = Precision::single_precision;
        parts_.push_back(part_of("time.precision", "time.precision = \"double\" (float instead)", rest));
    }

    void tolerance() {
        if (!scene_.time.tolerance) return;
        Scene rest = scene_;
        rest.time.tolerance.reset();
        const std::string value = quantity(*scene_.time.tolerance, "m/s");
        parts_.push_back(
            part_of("time.tolerance", "time.tolerance = " + value + " (the automatic step alone instead)", rest));
    }

    void grid() {
        const auto half = [](int masses) { return masses > 2 ? (masses - 1) / 2 + 1 : masses; };
        const int columns = half(scene_.flag.columns), rows = half(scene_.flag.rows);
        if (columns == scene_.flag.columns && rows == scene_.flag.rows) return;
        const std::string label = fmt::format("grid of {} x {} masses ({} x {} instead)", scene_.flag.columns,
                                              scene_.flag.rows, columns, rows);
        try {
            parts_.push_back(part_of("flag", label, same_cloth(scene_, columns, rows)));
        } catch (const InputError& impossible) {
            parts_.push_back({"flag", label, scene_, {}, impossible.what()});
        }
    }

    const Scene& scene_;
    std::vector<ScenePart> parts_;
};

}  // namespace

std::vector<ScenePart> parts_of(const Scene& scene) {
    return Listing(scene).all();
}

}  // namespace drapeau
