// Links to cells of small solids, and to groups of them, against the same in double.
#include <gonio/scene/stage.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/linked_cells.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_bundle.hpp>

#include "seen_places.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace gonio::detail {
namespace {

using test::Place;
using test::places_in;

Patches patches_of(const Stage& stage, double count) {
    return {stage, interest_of(stage, {}), {}, count, 1};
}

// A cell or a group.
struct Sender {
    glm::dvec3 position, normal;
    double half_diagonal_m, spread, area_m2;
    bool is_never_whole;
    double least; // half diagonals
};

Sender sender_of(const Patches& patches, std::uint32_t number) {
    if (number >= patches.cells().size()) {
        const CellGroup& group = patches.linked().groups()[number - patches.cells().size()];
        return {group.position, group.normal, group.half_diagonal_m, group.spread, group.seen_m2, false, 24.0};
    }
    const Cell& cell = patches.cells()[number];
    glm::dvec3 seen_m2(0.0);
    for (const std::uint32_t patch : patches.patches_of(number))
        seen_m2 += patches.area_m2(patch) * patches.normal(patch);
    const bool is_flat = patches.charts().all()[cell.chart].kind == Chart::Kind::flat;
    return {cell.position,       cell.normal,          cell.half_diagonal_m,
            cell.spread,         glm::length(seen_m2), cell.covered || cell.is_uneven(),
            is_flat ? 8.0 : 24.0};
}

TEST(LinkedCells, AreLinkedAsTheirFormFactorSays) {
    for (const char* name : {"street", "room", "spheres"}) {
        const Stage stage = make_stage(name).value();
        const Patches patches = patches_of(stage, 2000.0);
        const LinkedCells& linked = patches.linked();
        ASSERT_FALSE(linked.empty());
        for (const simd::InstructionSet set : simd::available_sets()) {
            std::size_t whole = 0;
            std::size_t divided = 0;
            CellLinks links;
            for (const Place& place : places_in(stage))
                for (const LinkedCells::OfChart& chart : linked.by_chart()) {
                    const std::size_t first = chart.whole.first;
                    linked.find_links(transport::ray_kernels(set), place.frame, false, chart, {first, chart.patches},
                                      links);
                    for (std::size_t i = first; i < chart.patches; ++i) {
                        const Sender sender = sender_of(patches, linked.part(i).number);
                        const float share = links.share[i - first];
                        const glm::dvec3 to = sender.position - place.frame.origin;
                        const double distance = glm::length(to);
                        const double here = glm::dot(place.frame.z, to) / distance;
                        const double there = -glm::dot(sender.normal, to) / distance;
                        // Away from where floats decide otherwise, and from those that are turned away in part.
                        if (here < 0.01 || there < sender.spread + 0.01) continue;
                        const double least = sender.least * sender.half_diagonal_m;
                        if (sender.is_never_whole || sender.spread > 0.4 || distance < 0.999 * least) {
                            ++divided;
                            EXPECT_EQ(share, transport::RayLinks::divided);
                        } else if (distance > 1.001 * least) {
                            ++whole;
                            const double factor =
                                here * there * sender.area_m2 / (std::numbers::pi * distance * distance);
                            EXPECT_NEAR(share, factor, 2e-5 * factor);
                            const glm::dvec3 towards(links.towards[0][i - first], links.towards[1][i - first],
                                                     links.towards[2][i - first]);
                            EXPECT_LE(glm::length(towards - place.frame.to_local(to / distance)), 2e-6);
                        }
                    }
                }
            EXPECT_GT(whole, 50U) << name;
            EXPECT_GT(divided, 50U) << name;
        }
    }
}

// Divided to the end, the whole of a small solid is each of its cells once, and each is in the groups that it came
// from.
TEST(LinkedCells, GroupsDivideIntoTheirCells) {
    std::size_t grouped = 0;
    for (const char* name : {"street", "card", "room", "spheres"}) {
        const Stage stage = make_stage(name).value();
        const Patches patches = patches_of(stage, 2000.0);
        const LinkedCells& linked = patches.linked();
        const auto cells = static_cast<std::uint32_t>(patches.cells().size());
        std::vector<std::uint32_t> met(cells, 0);
        const auto visit = [&](const auto& self, const LinkedCells::Range& parts,
                               std::uint32_t of) -> std::vector<std::uint32_t> {
            std::vector<std::uint32_t> all;
            for (std::size_t i = parts.first; i < parts.last; ++i) {
                const LinkedCells::Part& part = linked.part(i);
                EXPECT_EQ(linked.group_of(part.number), of);
                if (part.number < cells) {
                    ++met[part.number];
                    all.push_back(part.number);
                    continue;
                }
                std::vector<std::uint32_t> members = self(self, part.parts, part.number);
                std::vector<std::uint32_t> expected = linked.groups()[part.number - cells].cells;
                all.insert(all.end(), members.begin(), members.end());
                std::sort(members.begin(), members.end());
                std::sort(expected.begin(), expected.end());
                EXPECT_EQ(members, expected);
                EXPECT_GE(members.size(), 2U);
            }
            return all;
        };
        for (const LinkedCells::OfChart& chart : linked.by_chart())
            visit(visit, chart.whole, LinkedCells::no_group);
        std::vector<std::uint32_t> expected(cells, 0);
        for (const std::uint32_t cell : patches.linked_cells())
            expected[cell] = 1;
        EXPECT_EQ(met, expected) << name;
        grouped += linked.groups().size();
    }
    EXPECT_GT(grouped, 100U);
}

// The form factor of a group from the least distance at which it is linked as one, against the sum over its patches,
// and what it sends against what they do.
TEST(LinkedCells, GroupsStandForTheirPatches) {
    const Stage stage = make_stage("spheres").value();
    const Patches patches = patches_of(stage, 8000.0);
    std::vector<glm::dvec3> sent;
    for (std::uint32_t patch = 0; patch < patches.count(); ++patch)
        sent.emplace_back(1.0 + patches.normal(patch).x);
    const std::vector<Sent> by = by_sender(patches, sent);
    const std::vector<CellGroup>& groups = patches.linked().groups();
    std::size_t fine = 0;
    ASSERT_EQ(by.size(), patches.count() + patches.cells().size() + groups.size());
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const CellGroup& group = groups[i];
        glm::dvec3 mean(0.0);
        for (const std::uint32_t cell : group.cells)
            for (const std::uint32_t patch : patches.patches_of(cell))
                mean += patches.area_m2(patch) / group.area_m2 * sent[patch];
        EXPECT_NEAR(by[patches.count() + patches.cells().size() + i].rgb().x, mean.x, 1e-5);
        const auto compare = [&](double distance_m, double most) {
            for (const double angle : {0.0, 0.5, 0.9}) {
                if (std::sin(angle) + group.spread > 0.95) continue;
                const Frame frame = frame_about(group.position, group.normal);
                const glm::dvec3 away = frame.to_world({std::sin(angle), 0.0, std::cos(angle)});
                const glm::dvec3 from = group.position + distance_m * away;
                const auto factor = [&](const glm::dvec3& position, const glm::dvec3& normal, double area_m2) {
                    const glm::dvec3 to = from - position;
                    const double squared = glm::dot(to, to);
                    return glm::dot(normal, to) * glm::dot(away, to) * area_m2 / (squared * squared);
                };
                double expected = 0.0;
                for (const std::uint32_t cell : group.cells)
                    for (const std::uint32_t patch : patches.patches_of(cell))
                        expected += factor(patches.middle(patch), patches.normal(patch), patches.area_m2(patch));
                EXPECT_NEAR(factor(group.position, group.normal, group.seen_m2) / expected, 1.0, most)
                    << group.spread << ' ' << angle;
            }
        };
        compare(LinkedCells::least_for_coarse * group.half_diagonal_m, 0.035);
        if (group.spread <= LinkedCells::most_spread) {
            compare(LinkedCells::least_of_group * group.half_diagonal_m, 0.01);
            ++fine;
        }
    }
    EXPECT_GT(fine, 100U);
}

} // namespace
} // namespace gonio::detail
