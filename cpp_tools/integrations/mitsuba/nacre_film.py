# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""BSDF `nacre_film` of Mitsuba 3: a film by its reflectance over angle and wavelength.

    import mitsuba as mi
    mi.set_variant("scalar_spectral")
    import nacre_film
    nacre_film.register()  # anew after each set_variant()
    scene = mi.load_file("scene.xml")  # which includes the file that nacre export wrote

Spectral variants read `spectrum`: the columns are 360 … 830 nm, the rows cosθ from 0 to 1 in the
ambient, the channels R and T. RGB variants read `reflectance` and `transmittance`, which have cosθ along
their columns. The centres of the edge texels hold the ends of the axes. Light is unpolarised.

A rough film reflects by GGX (VNDF sampling) with the film's reflectance at each facet; what passes
goes on as through a smooth one. A solid seen from inside is taken to reflect as it does from outside
at the angle that Snell's law pairs, which holds for films that do not absorb.
"""

import drjit as dr
import mitsuba as mi

FIRST_NM, LAST_NM = 360.0, 830.0
UNSUPPORTED = "nacre_film: needs a spectral or RGB variant without polarisation (got {})"


def _texture(name):
    """The image of that name, or None for a material that has none."""
    if not name:
        return None
    texels = mi.TensorXf(mi.Bitmap(str(mi.file_resolver().resolve(name))))
    return mi.Texture2f(texels, filter_mode=dr.FilterMode.Linear, wrap_mode=dr.WrapMode.Clamp)


def _centre(fraction, texels):
    return (fraction * (texels - 1) + 0.5) / texels


def _bsdf_class():
    """Made anew for each variant, because its base class is one of the variant."""

    class NacreFilm(mi.BSDF):
        def __init__(self, props):
            mi.BSDF.__init__(self, props)
            if mi.is_polarized or not (mi.is_spectral or mi.is_rgb):
                raise RuntimeError(UNSUPPORTED.format(mi.variant()))
            # All are asked for: a property that nobody reads is an error in Mitsuba.
            spectrum, *colours = (
                str(props.get(name, "")) for name in ("spectrum", "reflectance", "transmittance")
            )
            self.tables = [_texture(name) for name in ([spectrum] if mi.is_spectral else colours)]
            self.alpha = float(props.get("alpha", 0.0))
            self.interior = str(props.get("interior", "opaque"))
            self.eta = float(props.get("eta", 1.0))
            self.base = props.get_texture("base") if self.interior == "diffuse" else None
            smooth = self.alpha < 1e-3
            lobe = mi.BSDFFlags.DeltaReflection if smooth else mi.BSDFFlags.GlossyReflection
            flags = [lobe | mi.BSDFFlags.FrontSide]
            if self.interior in ("thin_wall", "solid"):
                through = mi.BSDFFlags.Null if self.eta == 1.0 else mi.BSDFFlags.DeltaTransmission
                flags = [lobe | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide]
                flags.append(through | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide)
            elif self.base is not None:
                flags.append(mi.BSDFFlags.DiffuseReflection | mi.BSDFFlags.FrontSide)
            self.m_components = flags
            self.m_flags = flags[0] if len(flags) == 1 else flags[0] | flags[1]
            self.smooth = smooth

        # ---- What the film does at an angle -----------------------------------------------------

        def powers(self, cosine, si, active):
            """Reflectance and transmittance at a cosine in the ambient."""
            cosine = dr.clip(cosine, 0.0, 1.0)
            if not mi.is_spectral:
                found = []
                for table in self.tables:
                    if table is None:
                        found.append(mi.Color3f(0.0))
                        continue
                    at = mi.Point2f(_centre(cosine, table.shape[1]), 0.5)
                    found.append(mi.Color3f(*table.eval(at, active)))
                return found
            table = self.tables[0]
            height, width, channels = table.shape
            reflected, passed = [], []
            for wavelength in si.wavelengths:
                along = dr.clip((wavelength - FIRST_NM) / (LAST_NM - FIRST_NM), 0.0, 1.0)
                at = mi.Point2f(_centre(along, width), _centre(cosine, height))
                values = table.eval(at, active)
                reflected.append(values[0])
                passed.append(values[1] if channels > 1 else values[0] * 0.0)
            return mi.UnpolarizedSpectrum(reflected), mi.UnpolarizedSpectrum(passed)

        def cosine_outside(self, cosine):
            """In the ambient, of a cosine on either side; −1 for total reflection inside."""
            outside = 1.0 - self.eta**2 * (1.0 - cosine * cosine)
            inside = dr.select(outside < 0.0, -1.0, dr.sqrt(dr.maximum(outside, 0.0)))
            return dr.select(cosine >= 0.0, cosine, inside)

        def reflected_and_passed(self, cosine, si, active):
            if self.interior == "solid":
                cosine = self.cosine_outside(cosine)
            total = cosine < 0.0
            reflected, passed = self.powers(dr.abs(cosine), si, active)
            if self.interior == "solid":
                reflected = dr.select(total, 1.0, reflected)
                passed = dr.select(total, 0.0, passed)
            return reflected, passed

        def base_colour(self, si, wo, active):
            """Of the matt base under the film, times cosθ: what enters, leaves, and goes round."""
            cos_i, cos_o = mi.Frame3f.cos_theta(si.wi), mi.Frame3f.cos_theta(wo)
            albedo = self.base.eval(si, active)
            into, out = self.powers(cos_i, si, active)[1], self.powers(cos_o, si, active)[1]
            # Hemispherical mean by four Gauss–Legendre points of ∫ T dμ².
            nodes = (0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558)
            weights = (0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226)
            mean = 0.0
            for node, weight in zip(nodes, weights, strict=True):
                mean = mean + weight * self.powers(mi.Float(node**0.5), si, active)[1]
            inside = 1.0 - mean / self.eta**2
            matt = albedo / (1.0 - albedo * inside)
            return into * out * matt * (cos_o / (dr.pi * self.eta**2))

        # ---- The interface of a BSDF ------------------------------------------------------------

        def sample(self, ctx, si, sample1, sample2, active=True):
            cos_i = mi.Frame3f.cos_theta(si.wi)
            both_sides = self.interior in ("thin_wall", "solid")
            active = active & ((cos_i != 0.0) if both_sides else (cos_i > 0.0))
            reflected, passed = self.reflected_and_passed(
                dr.abs(cos_i) if self.interior == "thin_wall" else cos_i, si, active
            )
            share = self._share(reflected, passed, ctx)
            first = sample1 < share
            bs, weight = self._sample_reflection(si, sample2, reflected, active)
            bs.pdf *= share
            weight = weight / share
            if len(self.m_components) > 1:
                other, other_weight = self._sample_second(si, sample2, passed, active)
                other.pdf *= 1.0 - share
                other_weight = other_weight / dr.maximum(1.0 - share, 1e-6)
                bs = dr.select(first, bs, other)
                weight = dr.select(first, weight, other_weight)
                if self.base is not None and not self.smooth:
                    value, pdf = self.eval_pdf(ctx, si, bs.wo, active)
                    bs.pdf = pdf
                    weight = dr.select(pdf > 0.0, value / dr.maximum(pdf, 1e-12), 0.0)
            return bs, dr.select(active, weight, 0.0)

        def _share(self, reflected, passed, ctx):
            """Of samples that go to reflection."""
            through_too = ctx.is_enabled(mi.BSDFFlags.Transmission, 1)
            if self.base is None and (len(self.m_components) == 1 or not through_too):
                return mi.Float(1.0)
            bright, through = dr.mean(reflected), dr.mean(passed)
            return dr.clip(bright / dr.maximum(bright + through, 1e-6), 0.05, 0.95)

        def _sample_reflection(self, si, sample2, reflected, active):
            bs = mi.BSDFSample3f()
            bs.eta = 1.0
            bs.sampled_component = 0
            if self.smooth:
                bs.sampled_type = +mi.BSDFFlags.DeltaReflection
                bs.wo = mi.reflect(si.wi)
                bs.pdf = 1.0
                return bs, reflected
            bs.sampled_type = +mi.BSDFFlags.GlossyReflection
            side = dr.select(mi.Frame3f.cos_theta(si.wi) < 0.0, -1.0, 1.0)
            facets = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, self.alpha)
            wi = mi.Vector3f(si.wi.x, si.wi.y, side * si.wi.z)
            facet, density = facets.sample(wi, sample2)
            wo = mi.reflect(wi, facet)
            bs.wo = mi.Vector3f(wo.x, wo.y, side * wo.z)
            bs.pdf = density / (4.0 * dr.maximum(dr.dot(wo, facet), 1e-9))
            colour, _ = self.reflected_and_passed(side * dr.dot(wi, facet), si, active)
            good = (wo.z > 0.0) & (bs.pdf > 0.0)
            return bs, dr.select(good, colour * facets.smith_g1(wo, facet), 0.0)

        def _sample_second(self, si, sample2, passed, active):
            bs = mi.BSDFSample3f()
            bs.sampled_component = 1
            bs.eta = 1.0
            if self.base is not None:
                bs.sampled_type = +mi.BSDFFlags.DiffuseReflection
                bs.wo = mi.warp.square_to_cosine_hemisphere(sample2)
                bs.pdf = mi.warp.square_to_cosine_hemisphere_pdf(bs.wo)
                colour = self.base_colour(si, bs.wo, active)
                return bs, dr.select(bs.pdf > 0.0, colour / dr.maximum(bs.pdf, 1e-12), 0.0)
            bs.pdf = 1.0
            if self.eta == 1.0:
                bs.sampled_type = +mi.BSDFFlags.Null
                bs.wo = -si.wi
                return bs, passed
            cos_i = mi.Frame3f.cos_theta(si.wi)
            _, cos_t, eta_it, eta_ti = mi.fresnel(cos_i, self.eta)
            bs.sampled_type = +mi.BSDFFlags.DeltaTransmission
            bs.wo = mi.refract(si.wi, cos_t, eta_ti)
            bs.eta = eta_it
            return bs, passed * (eta_ti * eta_ti)  # radiance, which refraction compresses

        def eval(self, ctx, si, wo, active=True):
            return self.eval_pdf(ctx, si, wo, active)[0]

        def pdf(self, ctx, si, wo, active=True):
            return self.eval_pdf(ctx, si, wo, active)[1]

        def eval_pdf(self, ctx, si, wo, active=True):
            cos_i, cos_o = mi.Frame3f.cos_theta(si.wi), mi.Frame3f.cos_theta(wo)
            both_sides = self.interior in ("thin_wall", "solid")
            active = active & (cos_i * cos_o > 0.0) & (both_sides or cos_i > 0.0)
            value, density = mi.Spectrum(0.0), mi.Float(0.0)
            reflected, passed = self.reflected_and_passed(
                dr.abs(cos_i) if self.interior == "thin_wall" else cos_i, si, active
            )
            share = self._share(reflected, passed, ctx)
            if not self.smooth:
                side = dr.select(cos_i < 0.0, -1.0, 1.0)
                wi, out = si.wi * side, wo * side
                facets = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, self.alpha)
                facet = dr.normalize(wi + out)
                colour, _ = self.reflected_and_passed(side * dr.dot(wi, facet), si, active)
                lobe = facets.eval(facet) * facets.G(wi, out, facet) / (4.0 * dr.abs(cos_i))
                value = value + colour * lobe
                density += (
                    share * facets.pdf(wi, facet) / (4.0 * dr.maximum(dr.dot(out, facet), 1e-9))
                )
            if self.base is not None:
                value = value + self.base_colour(si, wo, active)
                density += (1.0 - share) * mi.warp.square_to_cosine_hemisphere_pdf(wo)
            return dr.select(active, value, 0.0), dr.select(active, density, 0.0)

        def traverse(self, callback):
            if self.base is not None:
                callback.put_object("base", self.base, mi.ParamFlags.Differentiable)

        def to_string(self):
            return f"NacreFilm[interior = {self.interior}, alpha = {self.alpha}, eta = {self.eta}]"

    return NacreFilm


def register():
    """Makes `nacre_film` known to the variant of Mitsuba that is set."""
    mi.register_bsdf("nacre_film", _bsdf_class())
