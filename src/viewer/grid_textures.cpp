#include "grid_textures.hpp"

namespace drapeau {

GridTextures::GridTextures() : x_(make_texture()), y_(make_texture()), z_(make_texture()) {
    for (const GLuint id : {x_.id(), y_.id(), z_.id()}) {
        glBindTexture(GL_TEXTURE_2D, id);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    }
}

void GridTextures::upload(const FieldBuffer<float>& position) {
    if (position.columns() != columns_ || position.rows() != rows_) allocate(position);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    int component = 0;
    for (const GLuint id : {x_.id(), y_.id(), z_.id()}) {
        glBindTexture(GL_TEXTURE_2D, id);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, stride_, rows_, GL_RED, GL_FLOAT,
                        position.component(component++).data());
    }
}

void GridTextures::allocate(const FieldBuffer<float>& position) {
    columns_ = position.columns();
    rows_ = position.rows();
    stride_ = position.stride();
    for (const GLuint id : {x_.id(), y_.id(), z_.id()}) {
        glBindTexture(GL_TEXTURE_2D, id);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, stride_, rows_, 0, GL_RED, GL_FLOAT, nullptr);
    }

    triangles_.span(columns_, rows_);
}

void GridTextures::bind() const {
    GLenum unit = GL_TEXTURE0;
    for (const GLuint id : {x_.id(), y_.id(), z_.id()}) {
        glActiveTexture(unit++);
        glBindTexture(GL_TEXTURE_2D, id);
    }
}

}  // namespace drapeau
