#include "scene_io/pbrt/write/write_model.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/math/reflectance.h"
#include "scene_io/pbrt/own_names.h"

namespace candela::pbrt {
namespace {

using description::Coat;
using description::ColourInput;
using description::Material;
using description::ScalarInput;

bool is_black(const ColourInput& input) {
  return input.is_constant() && input.factor == Vec3d(0.0);
}
double mean(const Vec3d& v) {
  return (v.x + v.y + v.z) / 3;
}

// kd / pi + a highlight of GGX: what pbrt has as a mixture of a diffuse surface and a metal, which
// is chosen with probability `amount`: of the metal's reflectance so much counts, at grazing angles
// as much of all light.
struct Highlight {
  ColourInput diffuse;
  ColourInput reflectance;  // straight on
  ScalarInput width;
  std::optional<std::array<Vec3d, 2>> eta_k = {};  // in place of the reflectance
  double amount = 1;
  double diffuse_scale = 1, reflectance_scale = 1;
};

// Of a mixture with textures, whose values are not known.
constexpr double even_amount = 0.5;

constexpr const char* make_named = "MakeNamedMaterial";

struct ModelWriter {
  const std::string& name;
  const Material& material;
  WriteContext& context;
  TextureWriter& textures;

  WrittenModel operator()(const description::DiffuseMaterial& m) const {
    return start("diffuse").add(textures.colour("reflectance", m.reflectance));
  }

  WrittenModel operator()(const description::MirrorMaterial& m) const {
    lose("pbrt's mirrors are metals: they reflect more at grazing angles");
    Directive out = start("conductor");
    out.add(textures.colour("reflectance", m.reflectance)).add("float roughness", 0.0);
    return out.add_own("string model", own::mirror)
        .add_own(textures.colour("mirror.reflectance", m.reflectance));
  }

  WrittenModel operator()(const description::ConductorMaterial& m) const {
    Directive out = start("conductor");
    if (m.reflectance)
      out.add(textures.colour("reflectance", *m.reflectance));
    else
      out.add("rgb eta", m.eta).add("rgb k", m.k);
    add_widths("", m.roughness, m.roughness_across, out);
    if (!m.energy_compensation) return out;
    lose("the light of further bounces between microfacets");
    return out.add_own("bool energycompensation", true);
  }

  WrittenModel operator()(const description::DielectricMaterial& m) const {
    Directive out = start(m.is_thin ? "thindielectric" : "dielectric");
    out.add("float eta", m.ior);
    if (!m.is_thin) add_widths("", m.roughness, m.roughness_across, out);
    if (m.transmittance == Vec3d(1.0)) return out;
    lose("the colour of what passes the surface");
    return out.add_own("rgb transmittance", m.transmittance);
  }

  WrittenModel operator()(const description::CoatedDiffuseMaterial& m) const {
    Directive out = start("coateddiffuse").add(textures.colour("reflectance", m.reflectance));
    add_coat("", m.coat, out);
    return out;
  }

  WrittenModel operator()(const description::CoatedConductorMaterial& m) const {
    Directive out = start("coatedconductor");
    out.add("rgb conductor.eta", m.eta).add("rgb conductor.k", m.k);
    add_widths("conductor.", m.roughness, m.roughness_across, out);
    add_coat("interface.", m.coat, out);
    return out;
  }

  WrittenModel operator()(const description::DiffuseTransmissionMaterial& m) const {
    return start("diffusetransmission")
        .add(textures.colour("reflectance", m.reflectance))
        .add(textures.colour("transmittance", m.transmittance));
  }

  WrittenModel operator()(const description::InterfaceMaterial&) const {
    return start("interface");
  }

  // Made of named materials: MaterialWriter's.
  WrittenModel operator()(const description::MixMaterial&) const { return start("mix"); }

  // At grazing angles Schlick's term lets ks of all light be reflected.
  WrittenModel operator()(const description::CookTorranceMaterial& m) const {
    Highlight h{m.diffuse, m.specular, m.roughness, m.eta_k, even_amount, 1, mean(m.f0)};
    if (m.specular.is_constant()) {
      h.reflectance.factor = m.specular.factor * m.f0;
      h.reflectance_scale = 1;
      h.amount = max_component(m.specular.factor);
    }
    WrittenModel model = is_black(m.specular) ? plain(m.diffuse) : highlight(h);
    Directive& out = model.directive;
    out.add_own("string model", own::cook_torrance);
    out.add_own(textures.colour("cooktorrance.diffuse", m.diffuse));
    out.add_own(textures.colour("cooktorrance.specular", m.specular));
    out.add_own(textures.scalar("cooktorrance.roughness", m.roughness));
    out.add_own("rgb cooktorrance.f0", m.f0);
    if (m.ior) out.add_own("float cooktorrance.ior", *m.ior);
    if (m.eta_k)
      out.add_own("rgb cooktorrance.eta", (*m.eta_k)[0])
          .add_own("rgb cooktorrance.k", (*m.eta_k)[1]);
    if (m.fresnel == description::FresnelModel::Exact)
      out.add_own("string cooktorrance.fresnel", own::exact);
    if (m.geometry == description::GeometryModel::Smith)
      out.add_own("string cooktorrance.geometry", own::smith);
    if (m.energy_compensation) out.add_own("bool energycompensation", true);
    return model;
  }

  WrittenModel operator()(const description::LabMaterial& m) const {
    // pbrt takes reflectances and not lab3's numbers, which are read through pow 2.2.
    ColourInput diffuse = m.diffuse;
    for (int c = 0; c < 3; ++c) diffuse.factor[c] = std::pow(std::max(diffuse.factor[c], 0.0), 2.2);
    const double width = width_of_exponent(m.shininess);
    Highlight h{diffuse, m.specular, {width, {}, 0, {}}, {}, even_amount};
    // lab3's diffuse part gets what the highlight leaves, on the way in and on the way out; and at
    // grazing angles the highlight reflects all.
    if (m.specular.is_constant()) {
      const double left = 1 - mean(m.specular.factor);
      h.diffuse_scale = left * left;
      if (diffuse.is_constant())
        h.amount = std::max(1 - h.diffuse_scale * max_component(diffuse.factor),
                            max_component(m.specular.factor));
    }
    WrittenModel model = is_black(m.specular) ? plain(diffuse) : highlight(h);
    Directive& out = model.directive;
    out.add_own("string model", own::lab);
    out.add_own(textures.colour("lab.diffuse", m.diffuse)).add_own("float lab.alpha", m.alpha);
    out.add_own(textures.colour("lab.specular", m.specular));
    out.add_own("float lab.shininess", m.shininess);
    const ScalarInput& opacity = material.opacity;
    if (!opacity.is_constant() || opacity.factor != 1)
      out.add_own(textures.scalar("lab.opacity", opacity));
    return model;
  }

 private:
  [[nodiscard]] Directive start(const char* type) const {
    return Directive(make_named, name).add("string type", type);
  }

  void lose(std::string_view what) const {
    context.warn(material.span,
                 fmt::format("material '{}': lost for pbrt: {}", material.name, what));
  }

  [[nodiscard]] std::string part_name(const std::string& part) const {
    return context.unique_name("material", name + " " + part);
  }

  [[nodiscard]] WrittenModel plain(const ColourInput& diffuse) const {
    return start("diffuse").add(textures.colour("reflectance", diffuse));
  }

  // The metal alone where nothing else reflects.
  [[nodiscard]] WrittenModel highlight(const Highlight& h) const {
    lose("the highlight's own Fresnel and geometry terms: it is a metal's");
    const double amount = std::clamp(h.amount, 0.01, 1.0);
    const bool is_metal = amount > 0.99 || is_black(h.diffuse);
    const double share = is_metal ? 1 : amount;
    const std::string metal_name = is_metal ? name : part_name("highlight");
    Directive metal(make_named, metal_name);
    metal.add("string type", "conductor");
    if (h.eta_k)
      metal.add("rgb eta", (*h.eta_k)[0]).add("rgb k", (*h.eta_k)[1]);
    else
      metal.add(textures.scaled_colour("reflectance", h.reflectance, h.reflectance_scale / share,
                                       largest_metal_reflectance));
    add_widths("", h.width, std::nullopt, metal);
    if (is_metal) return metal;
    const std::string diffuse_name = part_name("diffuse");
    Directive diffuse(make_named, diffuse_name);
    diffuse.add("string type", "diffuse")
        .add(textures.scaled_colour("reflectance", h.diffuse, h.diffuse_scale / (1 - share), 1));
    WrittenModel mixture =
        start("mix")
            .add("string materials", std::vector<std::string>{diffuse_name, metal_name})
            .add("float amount", share);
    mixture.parts = {std::move(diffuse), std::move(metal)};
    return mixture;
  }

  void add_widths(const std::string& prefix, const ScalarInput& along,
                  const std::optional<ScalarInput>& across, Directive& out) const {
    if (across) {
      out.add(textures.scalar(prefix + "uroughness", along));
      out.add(textures.scalar(prefix + "vroughness", *across));
    } else {
      out.add(textures.scalar(prefix + "roughness", along));
    }
    if (prefix != "conductor.") out.add("bool remaproughness", false);
  }

  // Interfaces without a limit are more than pbrt's random walk ever meets.
  void add_coat(const std::string& prefix, const Coat& coat, Directive& out) const {
    constexpr int practically_none = 1000;
    add_widths(prefix, coat.roughness, coat.roughness_across, out);
    out.add("float " + prefix + "eta", coat.ior).add("float thickness", coat.thickness);
    out.add("integer maxdepth", coat.max_depth > 0 ? coat.max_depth : practically_none);
  }
};

}  // namespace

WrittenModel write_model(const std::string& name, const Material& material, WriteContext& context,
                         TextureWriter& textures) {
  return std::visit(ModelWriter{name, material, context, textures}, material.model);
}

}  // namespace candela::pbrt
