#version 3.7;
// Written by yarte-convert from shapes.yarte. Render with: povray +FP16 +W64 +H48 -A File_Gamma=1
// Numbers are the scene's own, in its units.

#declare Image_Width = 64;
#declare Image_Height = 48;
#declare Display_Gamma = 2.2;
#declare Max_Recursion = 4; // secondary generations of rays
#declare World_Scale = 2048; // of all lengths: POV-Ray's tolerances are absolute; a power of two changes no digit
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

// An index of exactly 1 would pass rays on without counting a level: the nearest one that does not is used.
#macro Yarte_Interior(Ct, Index)
    #if (Ct > 0) interior { ior (abs(Index - 1) < 6e-8 ? 1 + pow(2, -23) : Index) } #end
#end

#macro Yarte_Material(A, D, S, N, Cr, Ct, Index)
    #if (vlength(S) = 0) #local Front = Yarte_Matt(A, D, Cr) #else #local Front = Yarte_Shiny(A, D, S, N, Cr) #end
    material { texture { Yarte_Sum(Front, Ct) } Yarte_Interior(Ct, Index) }
#end

#macro Yarte_Two_Sided(A, D, S, Back_A, Back_D, Back_S, N, Cr, Ct, Index)
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

// Into the axes X, Y, Z.
#macro Yarte_Turn(X, Y, Z)
    matrix <X.x, X.y, X.z, Y.x, Y.y, Y.z, Z.x, Z.y, Z.z, 0, 0, 0>
#end

#macro Yarte_Truncated_Cone(Radius, Cone_Height, Height)
    cone {
        <0, 0, 0>, Radius*World_Scale, Height*World_Scale*y, Radius*(Cone_Height - Height)/Cone_Height*World_Scale
        open
    }
#end

// The polygon with the vertices of the array P, in its own plane: POV-Ray drops one that is 1e-10 off. The plane passes
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

#declare Material_1 = Yarte_Material(<0.1, 0, 0>, <0.6, 0.5, 0.4>, <0.3, 0.2, 0.1>, 12.5, 0.25, 0, 0)
#declare Material_2 = Yarte_Material(<0.01, 0.02, 0.03>, <0.1, 0.1, 0.1>, <0, 0, 0>, 1, 0.1, 0.7, 1)
#declare Material_2_Back_1 = Yarte_Two_Sided(<0.01, 0.02, 0.03>, <0.1, 0.1, 0.1>, <0, 0, 0>, <0.5, 0, 0>, <0, 0.5, 0>, <0, 0, 0.5>, 1, 0.1, 0.7, 1)

Yarte_Camera(<0.1, 2.3, 9.7>, <0, 0.2, -0.001>, <0.1, 1, 0>, 30.5, 24.25)
background { rgb <0.1, 0.2, 0.3>*Exposure }

// light, line 8
light_source { <5, 9, 7>*World_Scale rgb 0.75*Exposure }

// light, line 9
light_source { <-5, 9, 7>*World_Scale rgb <0.25, 0.5, 0.125>*Exposure }

// sphere, line 14
sphere {
    <-3, 0.12345678901234568, 0.1>*World_Scale, 1.1*World_Scale
    material { Material_1 }
}

// box, line 15
box {
    -<1, 2, 3>/2*World_Scale, <1, 2, 3>/2*World_Scale
    material { Material_1 }
    translate <0, 0, 0>*World_Scale
}

// box, line 16
box {
    -<1, 1, 1>/2*World_Scale, <1, 1, 1>/2*World_Scale
    material { Material_1 }
    Yarte_Turn(<1, 0, 0>, <0, 1, 0>, <0, 0, 1>)
    translate <1.5, 0, 0>*World_Scale
}

// box, line 18
#declare Axes_4 = array[2] { <0.707, 0.707, 0>, <-0.707, 0.707, 0> } // as written; below, the rotation nearest to them
box {
    -<1, 1, 1>/2*World_Scale, <1, 1, 1>/2*World_Scale
    material { Material_1 }
    Yarte_Turn(<0.7071067811865476, 0.7071067811865476, 0>, <-0.7071067811865476, 0.7071067811865476, 0>, <0, 0, 1>)
    translate <3, 0, 0>*World_Scale
}

// cone, line 20
#declare Axes_5 = array[3] { <0, 0, 1>, <2, 0, 0>, <0, 0, 0> } // as written; below, the rotation nearest to them
cone {
    <0, 0, 0>, 0.5*World_Scale, 1.5*World_Scale*y, 0
    material { Material_1 }
    Yarte_Turn(<0, 0, 1>, <1, 0, 0>, <0, 1, 0>)
    translate <4.5, 0, 0>*World_Scale
}

// truncated cone, line 24
object {
    Yarte_Truncated_Cone(0.7, 3, 1.2)
    material { Material_2 }
    translate <0, 2, 0>*World_Scale
}

// disc, line 25
disc {
    <0, 0, 0>, y, 4*World_Scale
    material { Material_2_Back_1 }
    inverse
    translate <0, 5, 12>*World_Scale
}

// polygon, line 28
object {
    Yarte_Polygon(array[5] { <-1, -1, -2>, <1, -1, -2>, <1, 1, -2>, <0, 0.1, -2>, <-1, 1, -2> })
    material { Material_2_Back_1 }
}

// cylinder, line 31
cylinder {
    <0, 0, 0>, 1.5*World_Scale*y, 0.5*World_Scale
    material { Material_2 }
    translate <1, 2, 3>*World_Scale
}

// open cylinder, line 32
cylinder {
    <0, 0, 0>, 30*World_Scale*y, 0.5*World_Scale
    open
    material { Material_2_Back_1 }
    Yarte_Turn(<1, 0, 0>, <0, 0, 1>, <0, -1, 0>)
    translate <-1, 2, -9>*World_Scale
}

// frustum, line 35
#declare Axes_11 = array[2] { <0.707, 0.707, 0>, <-0.707, 0.707, 0> } // as written; below, the rotation nearest to them
cone {
    <0, 0, 0>, 0.5*World_Scale, 1.5*World_Scale*y, 0.25*World_Scale
    material { Material_2 }
    Yarte_Turn(<0.7071067811865476, 0.7071067811865476, 0>, <-0.7071067811865476, 0.7071067811865476, 0>, <0, 0, 1>)
    translate <-1, 2, 3>*World_Scale
}

// open cylinder, line 37
cylinder {
    <0, 0, 0>, 3*World_Scale*y, 5*World_Scale
    open
    material { Material_2 }
    inverse
    translate <0, 2, 8>*World_Scale
}
