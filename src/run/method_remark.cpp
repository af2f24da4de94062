#include "run/method_remark.hpp"

#include "io/text.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

namespace drapeau {

double softness(Method method, const Model& model, double dt) {
    return with_method(method, [&]<class M>(const M&) {
        if constexpr (requires { M::softness(1.0, 1.0, dt); })
            return M::softness(model.springs.stiffest(), model.springs.mass, dt);
        else
            return 1.0;
    });
}

double kept_at_one_hertz(Method method, double dt) {
    return with_method(method, [&]<class M>(const M&) {
        if constexpr (requires { M::amplitude_kept(1.0, dt); })
            return M::amplitude_kept(1.0, dt);
        else
            return 1.0;
    });
}

std::string method_remark(Method method, const Model& model, double dt) {
    constexpr double worth_a_word = 0.01;
    const double soft = softness(method, model, dt), kept = kept_at_one_hertz(method, dt);
    if (soft > 1.0 + worth_a_word)
        return fmt::format("{} makes springs {} times too soft at steps of {}", name_of(method), rounded(soft, 3),
                           quantity(dt, "s"));
    if (kept < 1.0 - worth_a_word)
        return fmt::format("{} damps by itself: at steps of {} a swing of 1 Hz keeps {:.0f} % of its size each period",
                           name_of(method), quantity(dt, "s"), 100.0 * kept);
    return "";
}

}  // namespace drapeau
