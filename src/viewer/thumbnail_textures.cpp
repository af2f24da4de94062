#include "thumbnail_textures.hpp"

namespace drapeau {

namespace {

constexpr int most_in_a_frame = 2;

GlTexture uploaded(const Image& image) {
    GlTexture texture = make_texture();
    GLint bound = 0;  // the passes rely on what they have bound
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, GLuint(bound));
    return texture;
}

}  // namespace

void ThumbnailTextures::serve(std::map<std::filesystem::path, Thumbnail>& thumbnails, Loader& loader, bool all) {
    for (auto& [file, thumbnail] : thumbnails) {
        if (thumbnail.wanted && !thumbnail.is_made) loader.load_small(file);
        thumbnail.wanted = false;
    }
    if (all) loader.wait();
    for (int taken = 0; all || taken < most_in_a_frame; ++taken) {
        const auto made = loader.take_small();
        if (!made) break;
        Thumbnail& thumbnail = thumbnails[made->file];
        thumbnail.is_made = true;
        if (!made->image) continue;
        thumbnail.width = made->image->width;
        thumbnail.height = made->image->height;
        thumbnail.texture = textures_.emplace_back(uploaded(*made->image)).id();
    }
}

}  // namespace drapeau
