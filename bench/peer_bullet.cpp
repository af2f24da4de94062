#include "peers.hpp"

#include "run/engine.hpp"

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
    Physics physics;
    btSoftBody flag;

    World(const Scene& scene, int iterations) : physics(scene), flag(&world.getWorldInfo()) {
        const Grid& grid = physics.grid;
        world.setGravity(to_bullet(physics.gravity.acceleration));
        world.getWorldInfo().m_gravity = to_bullet(physics.gravity.acceleration);
        world.getWorldInfo().air_density = 0;  // drag is the flag's own, below
        flag.appendMaterial()->m_kLST = 1;     // as stiff as its iterations can make it
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i) {
                const bool held = is_attached(physics.attach, grid, i, j);
                flag.appendNode(to_bullet(grid.rest(i, j)),
                                held ? btScalar(0) : static_cast<btScalar>(physics.material.mass));
            }
        for_each_spring(grid, physics.material, [&](int i, int j, int i2, int j2, double, double) {
            flag.appendLink(j * grid.columns + i, j2 * grid.columns + i2);
        });
        flag.m_cfg.piterations = iterations;
        flag.m_cfg.collisions = 0;
        flag.randomizeConstraints();
        world.addSoftBody(&flag);
        world.setInternalTickCallback(&World::blow, this, true);
    }
    ~World() { world.removeSoftBody(&flag); }

    static void blow(btDynamicsWorld* world, btScalar) {
        auto& self = *static_cast<World*>(world->getWorldUserInfo());
        const auto d = static_cast<btScalar>(self.physics.drag.d);
        const btVector3 wind = to_bullet(self.physics.wind.wind.mean);
        for (int n = 0; n < self.flag.m_nodes.size(); ++n) {
            auto& node = self.flag.m_nodes[n];
            if (node.m_im > 0) self.flag.addForce(d * (wind - node.m_v), n);
        }
    }

    double greatest_stretch() const {
        double stretch = -1.0;
        for_each_spring(physics.grid, physics.material, [&](int i, int j, int i2, int j2, double, double length) {
            const int a = j * physics.grid.columns + i, b = j2 * physics.grid.columns + i2;
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
