/// @file A scene of two nodes, a tool and two interfaces without segments, and one cycle of a made-up run on it.
#pragma once

#include <memory>

#include "reference/host/march.h"
#include "verification/support/scene_builder.h"

namespace type21::test {

struct RecordScene {
    std::shared_ptr<Model> model;
    HostScene scene;

    RecordScene() {
        SceneBuilder builder;
        builder.blank({Vec3(1, 2, 3)}, {}, 7).main_node({4, 5, 6}, 9);
        model = std::make_shared<Model>(builder.model());
        model->rigid_bodies[0].id = 3;
        model->interfaces.push_back(model->interfaces[0]);
        for (int i = 0; i < 2; ++i)
            model->interfaces[static_cast<size_t>(i)].id = 10 + i;
        scene = plan(model);
    }

    void request(HistoryRequest::Kind kind, std::vector<std::string> variables, std::vector<int> objects) {
        HistoryRequest request;
        request.kind = kind;
        request.variables = std::move(variables);
        request.objects = std::move(objects);
        model->histories.push_back(std::move(request));
    }
};

/// Everything that a CycleRecord points to.
struct Cycle {
    Motion motion;
    std::vector<Vec3> position{Vec3(1.5, 2, 3), Vec3(4, 5, 6.5)};
    std::vector<Vec3> velocity{Vec3(10, 20, 30), Vec3(40, 50, 60)};
    std::vector<Vec3> displacement{Vec3(0.5, 0, 0), Vec3(0, 0, 0.5)};
    std::vector<Vec3> angular_velocity{Vec3::Zero(), Vec3(0.1, 0.2, 0.3)};
    std::vector<Vec3> acceleration{Vec3(1, 1, 1), Vec3(2, 2, 2)};
    std::vector<Vec3> reaction{Vec3(-1, -2, -3), Vec3(-4, -5, -6)};
    std::vector<Vec3> reaction_moment{Vec3(7, 8, 9), Vec3(10, 11, 12)};
    std::vector<ContactStep> contacts{2};
    std::vector<InterfaceTotals> totals{2};

    CycleRecord record(long cycle, double time, double step, double next_step, bool last) {
        motion.time = time;
        motion.step = step;
        motion.position = position;
        motion.velocity = velocity;
        motion.tools.resize(1);
        motion.tools[0].position = position[1];
        motion.tools[0].velocity = velocity[1];
        motion.tools[0].angular_velocity = angular_velocity[1];
        CycleRecord record;
        record.cycle = cycle;
        record.time = time;
        record.step = step;
        record.next_step = next_step;
        record.motion = &motion;
        record.contacts = &contacts;
        record.totals = &totals;
        record.displacement = &displacement;
        record.angular_velocity = &angular_velocity;
        record.acceleration = &acceleration;
        record.reaction = &reaction;
        record.reaction_moment = &reaction_moment;
        record.last = last;
        return record;
    }
};

}  // namespace type21::test
