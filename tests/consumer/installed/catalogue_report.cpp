// A table of the profiles that are named: flux, peak and beam angle. What is wrong with a file goes to stderr.
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resolve.hpp>

#include <cstdio>

namespace {

void print(const gonio::Diagnostics& diagnostics) {
    for (const gonio::Diagnostic& one : diagnostics)
        std::fprintf(stderr, "%s\n", to_text(one).c_str());
}

bool report(const char* path) {
    const auto profile = gonio::read_profile_file(path);
    if (!profile) return print(profile.error().diagnostics), false;
    print(profile->diagnostics); // warnings: the file was read

    const auto resolved = gonio::resolve_web(*profile);
    if (!resolved) return print(resolved.error().diagnostics), false;
    print(resolved->diagnostics);

    const gonio::Web& web = resolved->web;
    const auto beam = gonio::spread_angle(web, 0.0, 0.5); // in C0–C180, at half of the peak
    std::printf("%s,%.1f,%.1f,%.1f\n", path, gonio::flux(web).value, gonio::peak(web).intensity.value,
                beam ? gonio::to_degrees(*beam) : 0.0);
    return true;
}

} // namespace

int main(int count, char** arguments) {
    std::puts("file,flux_lm,peak_cd,beam_deg");
    bool all = true;
    for (int i = 1; i < count; ++i)
        all = report(arguments[i]) && all;
    return all ? 0 : 1;
}
