#version 3.7;
// Written by yarte-convert from tints.yarte. Render with: povray +FP16 +W64 +H48 -A File_Gamma=1
// Numbers are the scene's own, in its units.

#declare Image_Width = 64;
#declare Image_Height = 48;
#declare Display_Gamma = 1;
#declare Max_Recursion = 2; // secondary generations of rays
#declare World_Scale = 16384; // of all lengths: POV-Ray's tolerances are absolute; a power of two changes no digit
#declare Exposure = 1; // of all light: POV-Ray's files end at 1

global_settings { assumed_gamma 1 max_trace_level Max_Recursion + 1 adc_bailout 0 }
#default { finish { ambient 0 diffuse 0 } }

// The local terms and the mirror as layers, the lowest first. An upper layer with transmit 1/2 shows the one below it by
// half, which factors of two undo; phong ignores pigments, so a filter above it tints it.
// (POV-Ray ends a list of layers at an #if and at a macro within a macro: hence the repetition.)
#macro Yarte_Matt(A, D, Cr)
    texture { pigment { rgb D } finish { diffuse 2 } }
    texture { pigment { rgbft <1, 1, 1, 0, 0.5> } finish { ambient rgb 2*A*Exposure reflection { rgb Cr } } }
#end

#macro Yarte_Shiny(A, D, S, N, Cr)
    texture { pigment { rgb 0 } finish { phong 4 phong_size N } }
    texture { pigment { rgbft <S.x, S.y, S.z, 1, 0> } }
    texture { pigment { rgbft <D.x, D.y, D.z, 0, 0.5> } finish { diffuse 4 } }
    texture { pigment { rgbft <1, 1, 1, 0, 0.5> } finish { ambient rgb 2*A*Exposure reflection { rgb Cr } } }
#end

// Layers + Ct times what lies behind, as an average whose weights add up to 1.
#declare Yarte_Clear = texture { pigment { rgbt <1, 1, 1, 1> } }
#declare Yarte_Black = texture { pigment { rgb 0 } }
#macro Yarte_Sum(Layers, Ct)
    #if (Ct = 0) Layers #else average texture_map { [1 Layers] [Ct Yarte_Clear] [-Ct Yarte_Black] } #end
#end

// The same where what lies behind, but not what is reflected totally, is tinted: by a filter.
#macro Yarte_Tinted_Sum(Layers, Ct, Tint)
    #if (Ct = 0)
        Layers
    #else
        average texture_map { [1 Layers] [Ct pigment { rgbf <Tint.x, Tint.y, Tint.z, 1> }] [-Ct pigment { rgb 0 }] }
    #end
#end

// An index of exactly 1 would pass rays on without counting a level: the nearest one that does not is used.
#macro Yarte_Interior(Ct, Index)
    #if (Ct > 0) interior { ior (abs(Index - 1) < 6e-8 ? 1 + pow(2, -23) : Index) } #end
#end

#macro Yarte_Material(A, D, S, N, Cr, Ct, Index)
    #if (vlength(S) = 0) #local Front = Yarte_Matt(A, D, Cr) #else #local Front = Yarte_Shiny(A, D, S, N, Cr) #end
    material { texture { Yarte_Sum(Front, Ct) } Yarte_Interior(Ct, Index) }
#end

#macro Yarte_Tinted_Material(A, D, S, N, Cr, Ct, Index, Tint)
    #if (vlength(S) = 0) #local Front = Yarte_Matt(A, D, Cr) #else #local Front = Yarte_Shiny(A, D, S, N, Cr) #end
    material { texture { Yarte_Tinted_Sum(Front, Ct, Tint) } Yarte_Interior(Ct*vlength(Tint), Index) }
#end

#macro Yarte_Tinted_Two_Sided(A, D, S, Back_A, Back_D, Back_S, N, Cr, Ct, Index, Tint)
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

// Right-handed; the apertures are half-angles in degrees. The nudge decides a tie: where an edge of a polygon passes exactly
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

#declare Material_1 = Yarte_Tinted_Material(<0.1, 0, 0>, <0.2, 0.1, 0.1>, <0.3, 0.3, 0.3>, 40, 0.1, 0.9, 1.5, <1, 0.5, 0.25>)
#declare Material_1_Back_1 = Yarte_Tinted_Two_Sided(<0.1, 0, 0>, <0.2, 0.1, 0.1>, <0.3, 0.3, 0.3>, <0, 0, 0.1>, <0.1, 0.1, 0.2>, <0, 0, 0>, 40, 0.1, 0.9, 1.5, <1, 0.5, 0.25>)
#declare Material_2 = Yarte_Material(<0, 0, 0>, <0.1, 0.1, 0.1>, <0, 0, 0>, 1, 0, 0.5, 1)

Yarte_Camera(<0, 1, 6>, <0, 0, 0>, <0, 1, 0>, 45, 45)
background { rgb <0, 0, 0>*Exposure }

// light, line 5
light_source { <3, 5, 4>*World_Scale rgb 0.9*Exposure }

// sphere, line 8
sphere {
    <-1, 0, 0>*World_Scale, 1*World_Scale
    material { Material_1 }
}

// disc, line 9
disc {
    <0, 0, 0>, y, 1*World_Scale
    material { Material_1_Back_1 }
    translate <1, 0, 0>*World_Scale
}

// sphere, line 12
sphere {
    <0, 2, 0>*World_Scale, 0.5*World_Scale
    material { Material_2 }
}
