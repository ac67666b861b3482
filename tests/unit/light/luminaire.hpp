// Shared by the tests of luminaires with a size: lights of a formula on an opening.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/light/luminaire.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/web/author.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace gonio::test {

inline std::shared_ptr<const Web> authored_web(const std::string& text) {
    return std::make_shared<const Web>(authored(parse_authored(text).value(), AuthorOptions()).value());
}

// Of 1000 lm, at the origin and aimed down; `size` says whether the opening is used.
inline Light luminaire(const std::string& formula, const std::string& opening,
                       ProfileSize size = ProfileSize::opening) {
    LightDescription description;
    description.name = formula;
    ProfileShape shape;
    shape.file = "made.ies";
    shape.web = authored_web(formula);
    shape.size = size;
    shape.given = std::make_shared<const Opening>(parse_opening(opening).value());
    description.shape = std::move(shape);
    Diagnostics diagnostics;
    return resolve_light(std::move(description), diagnostics).value();
}

} // namespace gonio::test
