#include "measure/run_cost.hpp"

#include "measure/clocks.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

Simulation simulation_at(Scene scene, const Stretch& stretch) {
    scene.flag.start = Start::flat;
    scene.flag.disturbance = 0.0;
    Simulation simulation(scene);
    simulation.put(stretch.start, stretch.time);
    simulation.use_own_thread();
    return simulation;
}

int times_for(double long_enough, double seconds) {
    constexpr double most_times = 200.0;
    return static_cast<int>(std::clamp(std::ceil(long_enough / std::max(seconds, 1e-9)), 1.0, most_times));
}

double run_cost(const Scene& scene, const Stretch& stretch, int times) {
    Simulation simulation = simulation_at(scene, stretch);
    simulation.advance_batch();  // warm
    double seconds = 0.0;
    for (int time = 0; time < times; ++time) {
        simulation.put(stretch.start, stretch.time);
        const double before = thread_seconds();
        for (long long batch = 0; batch < stretch.batches; ++batch) simulation.advance_batch();
        seconds += thread_seconds() - before;
    }
    return 1e3 * seconds / (times * stretch.seconds());
}

}  // namespace drapeau
