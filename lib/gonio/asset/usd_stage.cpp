// The stage in USD: solids of UsdGeom, and UsdPreviewSurface in its specular workflow, which has separate albedo and
// reflectance; roughness is the root of α. Transformations list rows.
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

#include <cmath>

namespace gonio::asset_detail {

namespace {

std::string material_text(const SceneMaterial& material, std::string_view scope) {
    const std::string coat = material.coat ? fmt::format("                float inputs:clearcoat = {}\n"
                                                         "                float inputs:clearcoatRoughness = {}\n",
                                                         material.coat->amount, 1.0 - material.coat->smoothness)
                                           : std::string();
    return fmt::format("        def Material \"{0}\"\n"
                       "        {{\n"
                       "            token outputs:surface.connect = <{1}/{0}/surface.outputs:surface>\n"
                       "            def Shader \"surface\"\n"
                       "            {{\n"
                       "                uniform token info:id = \"UsdPreviewSurface\"\n"
                       "                color3f inputs:diffuseColor = ({2})\n"
                       "                int inputs:useSpecularWorkflow = 1\n"
                       "                color3f inputs:specularColor = ({3})\n"
                       "                float inputs:roughness = {4}\n{5}"
                       "                token outputs:surface\n"
                       "            }}\n"
                       "        }}\n",
                       material.name, scope, triple(material.diffuse), triple(material.f0), std::sqrt(material.alpha),
                       coat);
}

std::string transform(const Frame& frame, const glm::dvec3& size = glm::dvec3(1.0)) {
    return fmt::format("        matrix4d xformOp:transform = ( ({}, 0), ({}, 0), ({}, 0), ({}, 1) )\n"
                       "        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n",
                       triple(size.x * frame.x), triple(size.y * frame.y), triple(size.z * frame.z),
                       triple(frame.origin));
}

struct Body {
    std::string_view type;
    std::string text;
};

struct BodyOf {
    Body operator()(const Panel& panel) const {
        return {"Mesh",
                fmt::format("        uniform bool doubleSided = 0\n"
                            "        float3[] extent = [({0}, {1}, 0), ({2}, {3}, 0)]\n"
                            "        int[] faceVertexCounts = [4]\n"
                            "        int[] faceVertexIndices = [0, 1, 2, 3]\n"
                            "        point3f[] points = [({0}, {1}, 0), ({2}, {1}, 0), ({2}, {3}, 0), ({0}, {3}, 0)]\n"
                            "        uniform token subdivisionScheme = \"none\"\n",
                            -0.5 * panel.width, -0.5 * panel.height, 0.5 * panel.width, 0.5 * panel.height) +
                    transform(panel.frame)};
    }
    Body operator()(const Ball& ball) const {
        return {"Sphere", fmt::format("        float3[] extent = [({0}, {0}, {0}), ({1}, {1}, {1})]\n"
                                      "        double radius = {1}\n",
                                      -ball.radius, ball.radius) +
                              transform(frame_of(ball))};
    }
    Body operator()(const Box& box) const {
        return {"Cube", "        float3[] extent = [(-1, -1, -1), (1, 1, 1)]\n        double size = 2\n" +
                            transform(box.frame, box.half_size)};
    }
    Body operator()(const Capsule& capsule) const {
        return {"Capsule", fmt::format("        uniform token axis = \"Z\"\n"
                                       "        float3[] extent = [({0}, {0}, {2}), ({1}, {1}, {3})]\n"
                                       "        double height = {4}\n"
                                       "        double radius = {1}\n",
                                       -capsule.radius, capsule.radius, -capsule.half_length - capsule.radius,
                                       capsule.half_length + capsule.radius, 2.0 * capsule.half_length) +
                               transform(frame_of(capsule))};
    }
};

} // namespace

std::string usd_stage(const SceneStage& stage, std::string_view root) {
    const std::string scope = fmt::format("/{}/materials", root);
    std::string text = "    def Scope \"materials\"\n    {\n";
    for (const SceneMaterial& material : stage.materials)
        text += material_text(material, scope);
    text += "    }\n";
    for (const SceneSurface& surface : stage.surfaces) {
        const Body body = std::visit(BodyOf{}, surface.shape);
        text +=
            fmt::format("    def {} \"{}\" (\n"
                        "        prepend apiSchemas = [\"MaterialBindingAPI\"]\n"
                        "    )\n"
                        "    {{\n"
                        "        rel material:binding = <{}/{}>\n"
                        "{}    }}\n",
                        body.type, identifier(surface.name), scope, stage.materials[surface.material].name, body.text);
    }
    constexpr double focal_length = 50.0;
    const double height = 2.0 * focal_length * std::tan(0.5 * stage.camera.vertical_fov);
    return text + fmt::format("    def Camera \"camera\"\n"
                              "    {{\n"
                              "        float2 clippingRange = (0.01, 10000)\n"
                              "        float focalLength = {}\n"
                              "        float horizontalAperture = {}\n"
                              "        float verticalAperture = {}\n"
                              "{}    }}\n",
                              focal_length, height * stage.camera.aspect(), height, transform(stage.camera.frame));
}

std::string usd_render_settings(const SceneStage& stage, std::string_view root) {
    return fmt::format("\n"
                       "def Scope \"Render\"\n"
                       "{{\n"
                       "    def RenderSettings \"settings\"\n"
                       "    {{\n"
                       "        rel camera = </{}/camera>\n"
                       "        uniform int2 resolution = ({}, {})\n"
                       "    }}\n"
                       "}}\n",
                       root, stage.camera.width, stage.camera.height);
}

} // namespace gonio::asset_detail
