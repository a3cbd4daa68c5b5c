#include "convert/povray/library.h"

#include <iterator>

namespace yarte::convert::povray {
namespace {

struct Macro {
    std::string_view name, text;
};

// Each uses only those before it. Parameters: A, D, S ambient, diffuse, specular; N exponent; Cr, Ct
// reflection, transmission. Materials with a tint have macros of their own, so that those without stay short.
constexpr Macro exactTextures[] = {
    {"Yarte_Matt",
     R"(// The local terms and the mirror as layers, the lowest first. An upper layer with transmit 1/2 shows the one below it by
// half, which factors of two undo; phong ignores pigments, so a filter above it tints it.
// (POV-Ray ends a list of layers at an #if and at a macro within a macro: hence the repetition.)
#macro Yarte_Matt(A, D, Cr)
    texture { pigment { rgb D } finish { diffuse 2 } }
    texture { pigment { rgbft <1, 1, 1, 0, 0.5> } finish { ambient rgb 2*A*Exposure reflection { rgb Cr } } }
#end
)"},
    {"Yarte_Shiny", R"(#macro Yarte_Shiny(A, D, S, N, Cr)
    texture { pigment { rgb 0 } finish { phong 4 phong_size N } }
    texture { pigment { rgbft <S.x, S.y, S.z, 1, 0> } }
    texture { pigment { rgbft <D.x, D.y, D.z, 0, 0.5> } finish { diffuse 4 } }
    texture { pigment { rgbft <1, 1, 1, 0, 0.5> } finish { ambient rgb 2*A*Exposure reflection { rgb Cr } } }
#end
)"},
    {"Yarte_Sum", R"(// Layers + Ct times what lies behind, as an average whose weights add up to 1.
#declare Yarte_Clear = texture { pigment { rgbt <1, 1, 1, 1> } }
#declare Yarte_Black = texture { pigment { rgb 0 } }
#macro Yarte_Sum(Layers, Ct)
    #if (Ct = 0) Layers #else average texture_map { [1 Layers] [Ct Yarte_Clear] [-Ct Yarte_Black] } #end
#end
)"},
};

constexpr Macro exactTints[] = {
    {"Yarte_Tinted_Sum",
     R"(// The same where what lies behind, but not what is reflected totally, is tinted: by a filter.
#macro Yarte_Tinted_Sum(Layers, Ct, Tint)
    #if (Ct = 0)
        Layers
    #else
        average texture_map { [1 Layers] [Ct pigment { rgbf <Tint.x, Tint.y, Tint.z, 1> }] [-Ct pigment { rgb 0 }] }
    #end
#end
)"},
};

constexpr Macro plainTextures[] = {
    {"Yarte_Plain",
     R"(// One texture. Exact but for these: specular colours become grey; a millionth stands in for zeros of D where A has none;
// total internal reflection has weight 1; with Ct = 1 nothing local is left.
#macro Yarte_Plain(A, D, S, N, Cr, Ct)
    #local Shown = (Ct < 1 ? 1 - Ct : 1);
    #local P = <max(D.x, min(1e-6, A.x*1e30)), max(D.y, min(1e-6, A.y*1e30)), max(D.z, min(1e-6, A.z*1e30))>;
    #local Ambient = <A.x/max(P.x, 1e-6), A.y/max(P.y, 1e-6), A.z/max(P.z, 1e-6)>;
    pigment { rgbt <P.x/Shown, P.y/Shown, P.z/Shown, Ct> }
    finish { ambient rgb Ambient*Exposure diffuse 1 phong max(S.x, S.y, S.z) phong_size N reflection { rgb Cr } }
#end
)"},
};

constexpr Macro plainTints[] = {
    {"Yarte_Plain_Filter", R"(// Below a plain texture: what it lets through is tinted.
#macro Yarte_Plain_Filter(Tint)
    pigment { rgbf <Tint.x, Tint.y, Tint.z, 1> }
#end
)"},
};

constexpr Macro interiors[] = {
    {"Yarte_Interior",
     R"(// An index of exactly 1 would pass rays on without counting a level: the nearest one that does not is used.
#macro Yarte_Interior(Ct, Index)
    #if (Ct > 0) interior { ior (abs(Index - 1) < 6e-8 ? 1 + pow(2, -23) : Index) } #end
#end
)"},
};

constexpr Macro exactMaterials[] = {
    {"Yarte_Material", R"(#macro Yarte_Material(A, D, S, N, Cr, Ct, Index)
    #if (vlength(S) = 0) #local Front = Yarte_Matt(A, D, Cr) #else #local Front = Yarte_Shiny(A, D, S, N, Cr) #end
    material { texture { Yarte_Sum(Front, Ct) } Yarte_Interior(Ct, Index) }
#end
)"},
    {"Yarte_Two_Sided", R"(#macro Yarte_Two_Sided(A, D, S, Back_A, Back_D, Back_S, N, Cr, Ct, Index)
    #if (vlength(S) = 0) #local Front = Yarte_Matt(A, D, Cr) #else #local Front = Yarte_Shiny(A, D, S, N, Cr) #end
    #if (vlength(Back_S) = 0)
        #local Back = Yarte_Matt(Back_A, Back_D, Cr)
    #else
        #local Back = Yarte_Shiny(Back_A, Back_D, Back_S, N, Cr)
    #end
    material {
        texture { Yarte_Sum(Front, Ct) }
        interior_texture { Yarte_Sum(Back, Ct) }
        Yarte_Interior(Ct, Index)
    }
#end
)"},
};

constexpr Macro exactTintedMaterials[] = {
    {"Yarte_Tinted_Material", R"(#macro Yarte_Tinted_Material(A, D, S, N, Cr, Ct, Index, Tint)
    #if (vlength(S) = 0) #local Front = Yarte_Matt(A, D, Cr) #else #local Front = Yarte_Shiny(A, D, S, N, Cr) #end
    material { texture { Yarte_Tinted_Sum(Front, Ct, Tint) } Yarte_Interior(Ct*vlength(Tint), Index) }
#end
)"},
    {"Yarte_Tinted_Two_Sided",
     R"(#macro Yarte_Tinted_Two_Sided(A, D, S, Back_A, Back_D, Back_S, N, Cr, Ct, Index, Tint)
    #if (vlength(S) = 0) #local Front = Yarte_Matt(A, D, Cr) #else #local Front = Yarte_Shiny(A, D, S, N, Cr) #end
    #if (vlength(Back_S) = 0)
        #local Back = Yarte_Matt(Back_A, Back_D, Cr)
    #else
        #local Back = Yarte_Shiny(Back_A, Back_D, Back_S, N, Cr)
    #end
    material {
        texture { Yarte_Tinted_Sum(Front, Ct, Tint) }
        interior_texture { Yarte_Tinted_Sum(Back, Ct, Tint) }
        Yarte_Interior(Ct*vlength(Tint), Index)
    }
#end
)"},
};

constexpr Macro plainMaterials[] = {
    {"Yarte_Material", R"(#macro Yarte_Material(A, D, S, N, Cr, Ct, Index)
    material { texture { Yarte_Plain(A, D, S, N, Cr, Ct) } Yarte_Interior(Ct, Index) }
#end
)"},
    {"Yarte_Two_Sided", R"(#macro Yarte_Two_Sided(A, D, S, Back_A, Back_D, Back_S, N, Cr, Ct, Index)
    material {
        texture { Yarte_Plain(A, D, S, N, Cr, Ct) }
        interior_texture { Yarte_Plain(Back_A, Back_D, Back_S, N, Cr, Ct) }
        Yarte_Interior(Ct, Index)
    }
#end
)"},
};

constexpr Macro plainTintedMaterials[] = {
    {"Yarte_Tinted_Material", R"(#macro Yarte_Tinted_Material(A, D, S, N, Cr, Ct, Index, Tint)
    material {
        texture { Yarte_Plain_Filter(Tint) }
        texture { Yarte_Plain(A, D, S, N, Cr, Ct) }
        Yarte_Interior(Ct*vlength(Tint), Index)
    }
#end
)"},
    {"Yarte_Tinted_Two_Sided",
     R"(#macro Yarte_Tinted_Two_Sided(A, D, S, Back_A, Back_D, Back_S, N, Cr, Ct, Index, Tint)
    material {
        texture { Yarte_Plain_Filter(Tint) }
        texture { Yarte_Plain(A, D, S, N, Cr, Ct) }
        interior_texture { Yarte_Plain_Filter(Tint) }
        interior_texture { Yarte_Plain(Back_A, Back_D, Back_S, N, Cr, Ct) }
        Yarte_Interior(Ct*vlength(Tint), Index)
    }
#end
)"},
};

constexpr Macro geometry[] = {
    {"Yarte_Camera",
     R"(// Right-handed; the apertures are half-angles in degrees. The nudge decides a tie: where an edge of a polygon passes exactly
// through pixels' centres, YARTE answers as if the ray lay a trifle further along x (for a view along z, and cyclically),
// POV-Ray by rounding errors. They are near 1e-11 here, and nothing else sees 1e-9.
#macro Yarte_Camera(Position, Focus, Up, Horizontal, Vertical)
    #local Forward = vnormalize(Focus - Position);
    #local Right = vnormalize(vcross(Forward, Up));
    #local Along_X = (abs(Forward.x) > max(abs(Forward.y), abs(Forward.z)));
    #local Along_Y = (abs(Forward.y) > max(abs(Forward.x), abs(Forward.z)));
    #local Nudge = (Along_X ? <0, 1, 0.1> : (Along_Y ? <0.1, 0, 1> : <1, 0.1, 0>))*1e-9;
    camera {
        perspective
        location Position*World_Scale + Nudge
        direction Forward
        right 2*tan(radians(Horizontal))*Right
        up 2*tan(radians(Vertical))*vcross(Right, Forward)
    }
#end
)"},
    {"Yarte_Turn", R"(// Into the axes X, Y, Z.
#macro Yarte_Turn(X, Y, Z)
    matrix <X.x, X.y, X.z, Y.x, Y.y, Y.z, Z.x, Z.y, Z.z, 0, 0, 0>
#end
)"},
    {"Yarte_Truncated_Cone", R"(#macro Yarte_Truncated_Cone(Radius, Cone_Height, Height)
    cone {
        <0, 0, 0>, Radius*World_Scale, Height*World_Scale*y, Radius*(Cone_Height - Height)/Cone_Height*World_Scale
        open
    }
#end
)"},
    {"Yarte_Polygon",
     R"(// The polygon with the vertices of the array P, in its own plane: POV-Ray drops one that is 1e-10 off. The plane passes
// through the mean with Newell's normal. POV-Ray takes the front from the first three vertices, and a first one that comes
// back splits the outline: so it starts before the widest left turn whose first vertex is there once.
#macro Yarte_Times(Q, P, Last)
    #local Times = 0;
    #for (I, 0, Last) #if (vlength(Q[I] - P) = 0) #local Times = Times + 1; #end #end
    Times
#end
#macro Yarte_Polygon(P)
    #local Last = dimension_size(P, 1) - 1;
    #local Mean = <0, 0, 0>;
    #for (I, 0, Last) #local Mean = Mean + P[I]; #end
    #local Mean = Mean/(Last + 1);
    #local Normal = <0, 0, 0>;
    #for (I, 0, Last) #local Normal = Normal + vcross(P[I] - Mean, P[mod(I + 1, Last + 1)] - Mean); #end
    #if (vlength(Normal)*World_Scale*World_Scale > 0)
        #local Normal = vnormalize(Normal);
        #local X_Axis = vnormalize(vcross((abs(Normal.x) < 0.6 ? x : y), Normal));
        #local Y_Axis = vcross(Normal, X_Axis);
        #local Q = array[Last + 1];
        #for (I, 0, Last) #local Q[I] = <vdot(P[I] - Mean, X_Axis), vdot(P[I] - Mean, Y_Axis), 0>*World_Scale; #end
        #local Start = 0;
        #local Widest = 0;
        #for (I, 0, Last)
            #local A = Q[mod(I + 1, Last + 1)] - Q[I];
            #local B = Q[mod(I + 2, Last + 1)] - Q[I];
            #local Turn = A.x*B.y - A.y*B.x;
            #if (Turn > Widest)
                #if (Yarte_Times(Q, Q[I], Last) = 1) #local Start = I; #local Widest = Turn; #end
            #end
        #end
        polygon {
            Last + 2 #for (I, 0, Last + 1), Q[mod(Start + I, Last + 1)] #end
            matrix <X_Axis.x, X_Axis.y, X_Axis.z, Y_Axis.x, Y_Axis.y, Y_Axis.z, Normal.x, Normal.y, Normal.z, 0, 0, 0>
            translate Mean*World_Scale
        }
    #end
#end
)"},
    {"Yarte_Place", R"(// A vertex of a mesh file in its place, by the operations of YARTE in their order.
#macro Yarte_Place(Vertex, Scale, X, Y, Z, Translation)
    (X*(Vertex.x*Scale) + Y*(Vertex.y*Scale) + Z*(Vertex.z*Scale) + Translation)
#end
)"},
    {"Yarte_Faces",
     R"(// The faces of a mesh: the array Faces holds, one after another, their number of corners and the corners' vertices.
// The front of a triangle is by the left-hand rule, of a polygon by the right-hand rule.
#macro Yarte_Faces(Vertices, Faces, Scale, X, Y, Z, Translation)
    #local Placed = array[dimension_size(Vertices, 1)];
    #for (I, 0, dimension_size(Vertices, 1) - 1)
        #local Placed[I] = Yarte_Place(Vertices[I], Scale, X, Y, Z, Translation);
    #end
    #local At = 0;
    #while (At < dimension_size(Faces, 1))
        #local Corners = Faces[At];
        #if (Corners = 3)
            #local A = Placed[Faces[At + 1]];
            #local B = Placed[Faces[At + 2]];
            #local C = Placed[Faces[At + 3]];
            #if (vlength(vcross(B - A, C - A))*World_Scale*World_Scale > 0)
                triangle { A*World_Scale, C*World_Scale, B*World_Scale }
            #end
        #else
            #local Face = array[Corners];
            #for (I, 0, Corners - 1) #local Face[I] = Placed[Faces[At + 1 + I]]; #end
            Yarte_Polygon(Face)
        #end
        #local At = At + Corners + 1;
    #end
#end
)"},
    {"Yarte_Smooth_Faces",
     R"(// The same for triangles with normals at their corners: Face_Normals holds three numbers of Normals for every face.
#macro Yarte_Smooth_Faces(Vertices, Faces, Normals, Face_Normals, Scale, X, Y, Z, Translation)
    #for (F, 0, dimension_size(Faces, 1)/4 - 1)
        #local A = Yarte_Place(Vertices[Faces[4*F + 1]], Scale, X, Y, Z, Translation);
        #local B = Yarte_Place(Vertices[Faces[4*F + 2]], Scale, X, Y, Z, Translation);
        #local C = Yarte_Place(Vertices[Faces[4*F + 3]], Scale, X, Y, Z, Translation);
        #if (vlength(vcross(B - A, C - A))*World_Scale*World_Scale > 0)
            smooth_triangle {
                A*World_Scale, Yarte_Place(Normals[Face_Normals[3*F]], 1, X, Y, Z, <0, 0, 0>),
                C*World_Scale, Yarte_Place(Normals[Face_Normals[3*F + 2]], 1, X, Y, Z, <0, 0, 0>),
                B*World_Scale, Yarte_Place(Normals[Face_Normals[3*F + 1]], 1, X, Y, Z, <0, 0, 0>)
            }
        #end
    #end
#end
)"},
    {"Yarte_Inside",
     R"(// For a union around the camera, whose polygons have no inside: a sphere that has one and that no ray meets.
#macro Yarte_Inside(Eye)
    sphere { Eye*World_Scale, 1 no_image no_reflection no_shadow }
#end
)"},
};

/// Puts the macros that `text` uses before it; the last is looked at first, as it may need those before it.
template <std::size_t count>
void prepend(std::string& library, std::string_view text, const Macro (&macros)[count]) {
    for (auto macro = std::rbegin(macros); macro != std::rend(macros); ++macro) {
        const std::string call = std::string(macro->name) + "(";
        if (text.find(call) == text.npos && library.find(call) == library.npos) continue;
        library.insert(0, std::string(macro->text) + (library.empty() ? "" : "\n"));
    }
}

/// Calls `use` with every text of the library.
template <typename Use>
void forEachMacro(const Use& use) {
    for (const Macro& macro : exactTextures) use(macro);
    for (const Macro& macro : exactTints) use(macro);
    for (const Macro& macro : plainTextures) use(macro);
    for (const Macro& macro : plainTints) use(macro);
    for (const Macro& macro : interiors) use(macro);
    for (const Macro& macro : exactMaterials) use(macro);
    for (const Macro& macro : exactTintedMaterials) use(macro);
    for (const Macro& macro : plainMaterials) use(macro);
    for (const Macro& macro : plainTintedMaterials) use(macro);
    for (const Macro& macro : geometry) use(macro);
}

} // namespace

bool isLibraryMacro(std::string_view name, std::string_view text) {
    bool found = false;
    const std::string begin = "#macro " + std::string(name) + "(";
    forEachMacro([&](const Macro& macro) {
        const std::size_t at = macro.text.find(begin); // Yarte_Polygon's text has another macro before it
        found |= at != macro.text.npos && macro.text.substr(at, text.size()) == text;
    });
    return found;
}

std::vector<std::string_view> libraryMacroNames() {
    std::vector<std::string_view> names;
    constexpr std::string_view begin = "#macro ";
    forEachMacro([&](const Macro& macro) {
        for (std::size_t at = macro.text.find(begin); at != macro.text.npos;
             at = macro.text.find(begin, at)) {
            at += begin.size();
            names.push_back(macro.text.substr(at, macro.text.find('(', at) - at));
        }
    });
    return names;
}

std::string libraryFor(std::string_view text, bool plain) {
    std::string library;
    prepend(library, text, geometry);
    if (plain) {
        prepend(library, text, plainTintedMaterials);
        prepend(library, text, plainMaterials);
        prepend(library, text, interiors);
        prepend(library, text, plainTints);
        prepend(library, text, plainTextures);
    } else {
        prepend(library, text, exactTintedMaterials);
        prepend(library, text, exactMaterials);
        prepend(library, text, interiors);
        prepend(library, text, exactTints);
        prepend(library, text, exactTextures);
    }
    return library;
}

} // namespace yarte::convert::povray
