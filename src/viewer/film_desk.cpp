#include "film_desk.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"

#include <algorithm>

namespace drapeau {

FilmPlan film_plan(const FilmDesk& desk, glm::ivec2 window, bool transparent) {
    const std::string file = meant_path(desk.file);
    if (file.empty()) throw InputError("a film needs a file name, for example my-flag.mp4");
    glm::ivec2 size = film_sizes[std::size_t(std::clamp(desk.size, 0, int(film_sizes.size()) - 1))];
    if (size.x == 0)
        size =
            glm::ivec2(std::max(2, window.x / 2 * 2), std::max(2, window.y / 2 * 2));  // even, as most formats want it
    FilmPlan plan{.file = std::filesystem::absolute(file),
                  .width = size.x,
                  .height = size.y,
                  .rate = film_rates[std::size_t(std::clamp(desk.rate, 0, int(film_rates.size()) - 1))],
                  .seconds = desk.seconds,
                  .loop = desk.loop,
                  .transparent = transparent};
    plan.from = double(plan.blended()) / plan.rate;
    return plan;
}

}  // namespace drapeau
