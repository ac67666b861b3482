// Bakes a profile to a texture in memory: the texels hold candela, their sum over the sphere is the flux.
#include <gonio/bake/bake.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/resolve.hpp>

#include <cstdio>

int main(int, char** arguments) {
    const auto profile = gonio::read_profile_file(arguments[1]);
    const auto resolved = profile ? gonio::resolve_web(*profile) : gonio::Unexpected(profile.error());
    gonio::BakeOptions options;
    options.layout = gonio::Layout::latlong;
    options.width = 64;
    options.height = 32;
    const auto texture = resolved ? gonio::bake_texture(resolved->web, options) : gonio::Unexpected(resolved.error());
    if (!texture) {
        std::puts(to_text(texture.error().diagnostics.back()).c_str());
        return 1;
    }
    std::printf("%d x %d texels, %g lm, the first texel %g cd\n", texture->image.width, texture->image.height,
                texture->texture_flux.value, static_cast<double>(texture->image.at(0, 0)[0]) * texture->cd_per_unit);
}
