#include "peers.hpp"

#include "drapeau/stability.hpp"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace drapeau::bench {
namespace {

btVector3 to_bullet(const glm::dvec3& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

/// A world with nothing in it but the flag.
struct World {
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btSoftRigidDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    Model model;
    double drag;
    btVector3 wind;
    btSoftBody flag;

    World(const Scene& scene, int iterations)
        : model(model_of(scene)),
          drag(model.terms.get<AirDrag>()->d),
          wind(to_bullet(model.terms.get<Wind>()->velocity)),
          flag(&world.getWorldInfo()) {
        const Grid& grid = model.grid;
        const btVector3 gravity = to_bullet(model.terms.get<Gravity>()->acceleration);
        world.setGravity(gravity);
        world.getWorldInfo().m_gravity = gravity;
        world.getWorldInfo().air_density = 0;  // drag is the flag's own, below
        flag.appendMaterial()->m_kLST = 1;     // as stiff as its iterations can make it
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i) {
                const double mass = model.held(i, j) ? 0.0 : model.mass(i, j);
                flag.appendNode(to_bullet(grid.rest(i, j)), static_cast<btScalar>(mass));
            }
        for_each_spring([&](int a, int b, double) { flag.appendLink(a, b); });
        flag.m_cfg.piterations = iterations;
        flag.m_cfg.collisions = 0;
        flag.randomizeConstraints();
        world.addSoftBody(&flag);
        world.setInternalTickCallback(&World::blow, this, true);
    }
    ~World() { world.removeSoftBody(&flag); }

    static void blow(btDynamicsWorld* world, btScalar) {
        auto& self = *static_cast<World*>(world->getWorldUserInfo());
        const auto d = static_cast<btScalar>(self.drag);
        for (int n = 0; n < self.flag.m_nodes.size(); ++n) {
            auto& node = self.flag.m_nodes[n];
            if (node.m_im > 0) self.flag.addForce(d * (self.wind - node.m_v), n);
        }
    }

    /// Calls visit(one mass, another, rest length) for every spring.
    template <class Visit>
    void for_each_spring(Visit&& visit) const {
        const Grid& grid = model.grid;
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i) {
                const int n = j * grid.columns + i, below = n + grid.columns;
                const bool has_right = i + 1 < grid.columns, has_below = j + 1 < grid.rows;
                if (has_right) visit(n, n + 1, grid.pitch_x);
                if (has_below) visit(n, below, grid.pitch_y);
                if (!has_right || !has_below || !model.has_diagonals()) continue;
                visit(n, below + 1, grid.pitch_diagonal());
                visit(n + 1, below, grid.pitch_diagonal());
            }
    }

    double greatest_stretch() const {
        double stretch = -1.0;
        for_each_spring([&](int a, int b, double length) {
            const double l = (flag.m_nodes[a].m_x - flag.m_nodes[b].m_x).length();
            stretch = std::max(stretch, l / length - 1.0);
        });
        return stretch;
    }
};

}  // namespace

Flight fly_bullet(const Scene& scene, int substeps, int iterations) {
    World world(scene, iterations);
    Flight flight{std::numeric_limits<double>::max(), -1.0};
    for (int frame = 0; frame < frames_flown; ++frame) {
        const auto begin = std::chrono::steady_clock::now();
        for (int n = 0; n < substeps; ++n)
            world.world.stepSimulation(static_cast<btScalar>(batch_seconds / substeps), 0);
        const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        if (frame < frames_flown - frames_watched) continue;
        flight.ms_a_frame = std::min(flight.ms_a_frame, ms);
        flight.greatest_stretch = std::max(flight.greatest_stretch, world.greatest_stretch());
    }
    return flight;
}

}  // namespace drapeau::bench
