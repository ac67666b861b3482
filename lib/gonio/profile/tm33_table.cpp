#include <gonio/base/sort_unique.hpp>
#include <gonio/base/text.hpp>
#include <gonio/profile/detail/tm33_fields.hpp>
#include <gonio/profile/detail/tm33_table.hpp>
#include <gonio/profile/scanner.hpp>

#include <algorithm>
#include <cstdint>

namespace gonio::profile_detail {

namespace {

std::vector<double> each_once(std::vector<double> angles) {
    sort_unique(angles);
    return angles;
}

class PointReader {
public:
    explicit PointReader(PointTable& table) : table_(table) {}

    void read(pugi::xml_node parent) {
        for (const pugi::xml_node node : parent.children()) {
            if (!is_intensity_point(node)) continue;
            if (!add(node)) return;
        }
        make_grid();
    }

private:
    bool add(pugi::xml_node node) {
        const pugi::xml_attribute h = horizontal_of(node);
        const pugi::xml_attribute v = vertical_of(node);
        if (!h || !v) return fail(PointTable::Problem::angle_missing, node.name(), node.name());
        double horizontal = 0.0;
        double vertical = 0.0;
        double value = 0.0;
        if (!number(node, h.value(), horizontal) || !number(node, v.value(), vertical) ||
            !number(node, node.child_value(), value))
            return false;
        const pugi::xml_attribute third = node.first_attribute().next_attribute().next_attribute();
        const pugi::xml_node content = node.first_child();
        table_.plain = table_.plain && !third && content.type() == pugi::node_pcdata && !content.next_sibling();
        horizontals_.push_back(horizontal);
        verticals_.push_back(vertical);
        values_.push_back(value);
        places_.push_back(node.name());
        return true;
    }

    bool number(pugi::xml_node node, const char* written, double& value) {
        const std::string_view text = trimmed(written);
        bool plain = true;
        const Token token = scan_number(text, value, plain);
        if (token == Token::number) return true;
        return fail(token == Token::not_finite ? PointTable::Problem::not_finite : PointTable::Problem::not_a_number,
                    text.empty() ? node.name() : text.data(), text.substr(0, 40));
    }

    bool fail(PointTable::Problem problem, const char* where, std::string_view text) {
        table_.problem = problem;
        table_.where = where;
        table_.text = text;
        return false;
    }

    void make_grid() {
        table_.points = values_.size();
        table_.horizontal_deg = each_once(horizontals_);
        table_.vertical_deg = each_once(verticals_);
        const std::size_t rows = table_.vertical_deg.size();
        // Neither factor exceeds the number of points, which is bounded by the bytes of the file.
        const std::uint64_t places = std::uint64_t{table_.horizontal_deg.size()} * rows;
        if (places > values_.size()) {
            fail(PointTable::Problem::incomplete, places_.front(), {});
            return;
        }
        table_.values.resize(values_.size());
        std::vector<bool> seen(static_cast<std::size_t>(places), false);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const std::size_t at =
                index_of(table_.horizontal_deg, horizontals_[i]) * rows + index_of(table_.vertical_deg, verticals_[i]);
            if (seen[at]) {
                fail(PointTable::Problem::duplicate, places_[i], {});
                return;
            }
            seen[at] = true;
            table_.values[at] = values_[i];
        }
    }

    static std::size_t index_of(const std::vector<double>& angles, double angle) {
        return static_cast<std::size_t>(std::lower_bound(angles.begin(), angles.end(), angle) - angles.begin());
    }

    PointTable& table_;
    std::vector<double> horizontals_;
    std::vector<double> verticals_;
    std::vector<double> values_;
    std::vector<const char*> places_;
};

} // namespace

PointTable read_points(pugi::xml_node parent) {
    PointTable table;
    PointReader(table).read(parent);
    return table;
}

} // namespace gonio::profile_detail
