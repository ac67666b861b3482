// The example of lib/README.md.
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>

#include <cstdio>

int main(int, char** arguments) {
    const auto profile = gonio::read_profile_file(arguments[1]);
    if (!profile) {
        std::puts(to_text(profile.error().diagnostics.back()).c_str());
        return 1;
    }
    const auto resolved = gonio::resolve_web(*profile);
    if (!resolved) {
        std::puts(to_text(resolved.error().diagnostics.back()).c_str());
        return 1;
    }
    std::printf("%g lm, %g cd straight down\n", gonio::flux(resolved->web).value, resolved->web.candela(0.0, 0.0));
}
