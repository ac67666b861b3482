// libFuzzer: for any bytes, a table of numbers is refused with one reason that names its place, or is sound and the
// same after writing and reading it again. The first byte selects: 'a' a web in CSV (make csv:FILE), 'b' points
// (--points FILE).
#include <gonio/base/unit_text.hpp>
#include <gonio/web/author_csv.hpp>

#include "../../cli/options/points_input.hpp"
#include "check.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using namespace gonio::fuzz;

bool same_web(const Web& a, const Web& b) {
    const auto equal = [](std::span<const double> x, std::span<const double> y) {
        return std::equal(x.begin(), x.end(), y.begin(), y.end());
    };
    if (a.stored_symmetry() != b.stored_symmetry() || !equal(a.planes_deg(), b.planes_deg()) ||
        !equal(a.gammas_deg(), b.gammas_deg()))
        return false;
    for (std::size_t i = 0; i < a.planes_deg().size(); ++i)
        if (!equal(a.column(i), b.column(i))) return false;
    return true;
}

std::string as_csv(const Web& web) {
    std::string text = "C";
    for (const double gamma : web.gammas_deg())
        text += "," + shortest(gamma);
    for (std::size_t i = 0; i < web.planes_deg().size(); ++i) {
        text += "\n" + shortest(web.planes_deg()[i]);
        for (const double candela : web.column(i))
            text += "," + shortest(candela);
    }
    return text;
}

void check_web(std::string_view text) {
    const Result<Web> web = read_twice([&] { return web_from_csv(text, "fuzz.csv"); }, same_web);
    if (!web) return;
    for (std::size_t i = 0; i < web->planes_deg().size(); ++i)
        for (const double candela : web->column(i))
            require(std::isfinite(candela));
    for (const double gamma : {0.0, 12.5, 90.0, 180.0})
        for (const double c : {0.0, 33.0, 359.0})
            require(std::isfinite(web->candela(c, gamma)));
    const Result<Web> again = web_from_csv(as_csv(*web), "again.csv");
    require(again.has_value() && same_web(*web, *again));
}

bool same_points(const std::vector<Receiver>& a, const std::vector<Receiver>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Receiver& x, const Receiver& y) {
        return x.position == y.position && x.normal == y.normal;
    });
}

void check_points(std::string_view text) {
    const auto read = [](std::string_view rows) { return cli::parse_points(rows, "fuzz.csv", {0.0, 0.0, 1.0}); };
    const Result<std::vector<Receiver>> points = read_twice([&] { return read(text); }, same_points);
    if (!points) return;
    require(!points->empty() && points->size() <= cli::max_points);
    std::string written;
    for (const Receiver& point : *points) {
        for (const double value :
             {point.position.x, point.position.y, point.position.z, point.normal.x, point.normal.y, point.normal.z}) {
            require(std::isfinite(value));
            written += shortest(value) + ",";
        }
        written.back() = '\n';
    }
    const Result<std::vector<Receiver>> again = read(written);
    require(again.has_value() && same_points(*points, *again));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = as_text(data, size);
    if (text.empty()) return 0;
    if (take_choice(text, 2) == 0)
        check_web(text);
    else
        check_points(text);
    return 0;
}
