// A person's silhouette, 1.75 m tall, that always faces the viewer: a scale.
#pragma once

#include "gl_objects.hpp"
#include "picture.hpp"
#include "shader.hpp"

namespace drapeau {

class PersonPass {
public:
    PersonPass() : nothing_(make_vertex_array()) {}

    void draw(const Stage& stage) const;

private:
    Shader shader_{"person"};
    GlVertexArray nothing_;
};

}  // namespace drapeau
