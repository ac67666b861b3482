// Maps the elements of a TM-33 document to fields: shared by reader, writer and checks. Internal.
#pragma once

#include <gonio/profile/profile.hpp>

#include <pugixml.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::profile_detail {

// Names without a namespace's prefix.
std::string_view local_name(const char* name);

// The first child element of that name, or none.
pugi::xml_node child_named(pugi::xml_node parent, std::string_view name);

// Follows "LuminousData/LuminousFlux" from `parent`; the first of `paths` that exists, or none.
pugi::xml_node element_at(pugi::xml_node parent, std::string_view path);
pugi::xml_node first_of(pugi::xml_node parent, std::span<const std::string_view> paths);

// A number in an element of `Owner`. The first path is the schema's, the second that of other editions and programs.
using Paths = std::array<std::string_view, 2>;

template<class Owner>
struct NumberField {
    Paths paths;
    std::optional<double> Owner::*member;
};

template<class Owner>
struct TextField {
    Paths paths;
    std::string Owner::*member;
};

inline constexpr std::array<NumberField<Tm33Emitter>, 15> emitter_numbers{{
    {Paths{"Quantity"}, &Tm33Emitter::quantity},
    {Paths{"RatedLumens"}, &Tm33Emitter::rated_lumens},
    {Paths{"InputWattage", "InputWatts"}, &Tm33Emitter::input_watts},
    {Paths{"PowerFactor"}, &Tm33Emitter::power_factor},
    {Paths{"BallastFactor"}, &Tm33Emitter::ballast_factor},
    {Paths{"ColorTemperature/FixedCCT", "CCT"}, &Tm33Emitter::cct_k},
    {Paths{"ColorTemperature/MinCCT"}, &Tm33Emitter::min_cct_k},
    {Paths{"ColorTemperature/MaxCCT"}, &Tm33Emitter::max_cct_k},
    {Paths{"ColorRendering/CIE_CRI/Ra", "ColorRendering/Ra"}, &Tm33Emitter::cri_ra},
    {Paths{"ColorRendering/CIE_CRI/R9", "ColorRendering/R9"}, &Tm33Emitter::cri_r9},
    {Paths{"ColorRendering/IES_TM30/Rf", "ColorRendering/Rf"}, &Tm33Emitter::tm30_rf},
    {Paths{"ColorRendering/IES_TM30/Rg", "ColorRendering/Rg"}, &Tm33Emitter::tm30_rg},
    {Paths{"Duv"}, &Tm33Emitter::duv},
    {Paths{"SPRatio"}, &Tm33Emitter::sp_ratio},
    {Paths{"LuminousData/LuminousFlux", "MeasuredLumens"}, &Tm33Emitter::luminous_flux_lm},
}};

inline constexpr std::array<TextField<Tm33Emitter>, 2> emitter_texts{{
    {Paths{"Description"}, &Tm33Emitter::description},
    {Paths{"CatalogNumber"}, &Tm33Emitter::catalog_number},
}};

inline constexpr std::array<NumberField<Tm33File>, 4> luminaire_numbers{{
    {Paths{"Luminaire/Dimensions/Length"}, &Tm33File::length_m},
    {Paths{"Luminaire/Dimensions/Width"}, &Tm33File::width_m},
    {Paths{"Luminaire/Dimensions/Height"}, &Tm33File::height_m},
    {Paths{"Luminaire/NumEmitter", "Luminaire/NumEmitters"}, &Tm33File::emitter_count},
}};

inline constexpr std::array<std::string_view, 3> goniometer_paths{
    "Equipment/Gonioradiometer/Type", "Equipment/Goniometer/GoniometerType", "Equipment/Goniometer/Type"};

// The element that has the points of the luminous intensity as children; none if there is none. Programs that write
// "LuminaireOpticalData" call it IntensityDistribution, or leave LuminousIntensity out.
pugi::xml_node intensity_element(pugi::xml_node emitter);

// Points of a table: <IntData h="0" v="5">, or <IntensityData horz="0" vert="5">.
bool is_intensity_point(pugi::xml_node node);
pugi::xml_attribute horizontal_of(pugi::xml_node point);
pugi::xml_attribute vertical_of(pugi::xml_node point);

// One element per spectrum: SpectralData/EmitterSpectral with <PwrData w="550">, or SpectralDistribution with lists or
// points.
std::vector<pugi::xml_node> spectrum_elements(pugi::xml_node emitter);
bool is_spectrum_point(pugi::xml_node node);

// "Symm_Bi_0", with any spacing; nothing for other words.
std::optional<Tm33Symmetry> symmetry_named(std::string_view text);
const char* name_of(Tm33Symmetry symmetry);

// true, false, 1, 0 in any case; nothing for other words.
std::optional<bool> truth_of(std::string_view text);

// A number, with or without blanks around it; nothing for other text.
std::optional<double> plain_number(std::string_view text);

} // namespace gonio::profile_detail
