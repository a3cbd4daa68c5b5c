#include "convert/povray/sdl/words.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_set>

namespace yarte::convert::povray::sdl {
namespace {

constexpr std::string_view objects[] = {
    "bicubic_patch", "blob",         "box",          "cone",
    "cubic",         "cylinder",     "difference",   "disc",
    "height_field",  "intersection", "isosurface",   "julia_fractal",
    "lathe",         "light_source", "merge",        "mesh",
    "mesh2",         "object",       "ovus",         "parametric",
    "plane",         "poly",         "polygon",      "polynomial",
    "prism",         "quadric",      "quartic",      "smooth_triangle",
    "sor",           "sphere",       "sphere_sweep", "superellipsoid",
    "text",          "torus",        "triangle",     "union",
};

// The manual's list of reserved words, without those of objects and directives.
constexpr std::string_view others =
    "aa_level aa_threshold abs absorption accuracy acos acosh adaptive adc_bailout agate agate_turb all "
    "all_intersections alpha altitude always_sample ambient ambient_light angle aperture aoi arc_angle "
    "area_light "
    "area_illumination array asc ascii asin asinh assumed_gamma atan atan2 atanh autostop average b_spline "
    "background bezier_spline bitwise_and bitwise_or bitwise_xor black_hole blink blue blur_samples "
    "bounded_by "
    "box_mapping bozo brick brick_size brightness brilliance bump_map bump_size bumps camera caustics ceil "
    "cells "
    "charset checker chr circular clipped_by clock clock_delta clock_on collect color color_map colour "
    "colour_map "
    "component composite concat confidence conic_sweep conserve_energy contained_by control0 control1 coords "
    "cos "
    "cosh count crackle crand cube cubic_spline cubic_wave cutaway_textures cylindrical datetime deprecated "
    "defined "
    "degrees density density_file density_map dents df3 diffuse dimensions dimension_size direction "
    "dispersion "
    "dispersion_samples dist_exp distance div double_illuminate eccentricity emission error_bound evaluate "
    "evaluate exp expand_thresholds exponent exterior extinction face_indices facets fade_color fade_colour "
    "fade_distance fade_power falloff falloff_angle false file_exists filter final_clock final_frame finish "
    "fisheye "
    "flatness flip floor focal_point fog fog_alt fog_offset fog_type form frame_number frequency fresnel "
    "function "
    "gather gamma gif global_lights global_settings gradient granite gray gray_threshold green h_angle "
    "hexagon "
    "hf_gray_16 hierarchy hypercomplex hollow iff image_height image_map image_pattern image_width "
    "initial_clock "
    "initial_frame input_file_name inside inside_vector int interior interior_texture internal interpolate "
    "intervals inverse ior irid irid_wavelength jitter jpeg lambda leopard light_group linear_spline "
    "linear_sweep ln load_file location log look_at looks_like low_error_factor major_radius mandel map_type "
    "marble "
    "material material_map matrix max max_extent max_gradient max_intersections max_iteration max_sample "
    "max_trace max_trace_level media media_attenuation media_interaction metallic method metric min "
    "min_extent "
    "minimum_reuse mod mortar natural_spline nearest_count no no_bump_scale no_cache no_image no_reflection "
    "no_radiosity no_shadow noise_generator normal normal_indices normal_map normal_vectors number_of_sides "
    "number_of_tiles number_of_waves off offset omega omnimax on once onion open orientation origin "
    "orthographic panoramic parallel pass_through pattern perspective pgm phase phong phong_size photons pi "
    "pigment pigment_map pigment_pattern planar png point_at polarity poly_wave pot pow ppm precompute "
    "precision "
    "pretrace_start pretrace_end prod projected_through pwr quadratic_spline quadric quaternion quick_color "
    "quick_colour quilted radial radians radiosity radius rainbow ramp_wave rand ratio reciprocal "
    "recursion_limit red reflection reflection_exponent refraction repeat rgb rgbf rgbft rgbt right ripples "
    "rotate roughness samples save_file scale scallop_wave scattering seed select shadowless sin sine_wave "
    "sinh "
    "sint16be sint16le sint32be sint32le sint8 size sky sky_sphere slice slope slope_map smooth "
    "solid spacing specular spherical spiral spiral1 spiral2 spline split_union "
    "spotlight spotted sqr sqrt srgb srgbf srgbft srgbt statistics str strcmp strength strlen strlwr strupr "
    "sturm "
    "substr subsurface sum sys t tan tanh target texture texture_list texture_map tga thickness threshold "
    "tiff tightness tile2 tiles tolerance toroidal trace transform translate translucency transmit "
    "triangle_wave true ttf turb_depth turbulence type u u_steps ultra_wide_angle up use_alpha use_color "
    "use_colour use_index utf8 uv_indices uv_mapping uv_vectors v v_angle v_steps val variance vaxis_rotate "
    "vcross "
    "vdot version vertex_vectors vlength vnormalize vrotate vstr vturbulence warp water_level waves "
    "width wood wrinkles x y yes z";

const std::unordered_set<std::string_view>& objectWords() {
    static const std::unordered_set<std::string_view> set(std::begin(objects), std::end(objects));
    return set;
}

std::unordered_set<std::string_view> allWords() {
    std::unordered_set<std::string_view> set = objectWords();
    for (std::size_t at = 0; at < others.size();) {
        const std::size_t end = std::min(others.find(' ', at), others.size());
        set.insert(others.substr(at, end - at));
        at = end + 1;
    }
    return set;
}

} // namespace

bool isReserved(std::string_view word) {
    static const std::unordered_set<std::string_view> words = allWords();
    return words.contains(word);
}

bool isObjectKeyword(std::string_view word) { return objectWords().contains(word); }

} // namespace yarte::convert::povray::sdl
