#version 3.7;
// Written by yarte-convert from meshes.yarte. Render with: povray +FP16 +W256 +H256 -A File_Gamma=1
// Numbers are the scene's own, in its units.

#declare Image_Width = 256;
#declare Image_Height = 256;
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

// A vertex of a mesh file in its place, by the operations of YARTE in their order.
#macro Yarte_Place(Vertex, Scale, X, Y, Z, Translation)
    (X*(Vertex.x*Scale) + Y*(Vertex.y*Scale) + Z*(Vertex.z*Scale) + Translation)
#end

// The faces of a mesh: the array Faces holds, one after another, their number of corners and the corners' vertices.
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

// The same for triangles with normals at their corners: Face_Normals holds three numbers of Normals for every face.
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

#declare Material_1 = Yarte_Material(<0.1, 0.1, 0.1>, <0.6, 0.5, 0.4>, <0.3, 0.3, 0.3>, 20, 0, 0, 0)
#declare Material_2 = Yarte_Material(<0, 0, 0>, <0.1, 0.1, 0.1>, <0.3, 0.3, 0.3>, 20, 0, 0.9, 1.5)
#declare Material_2_Back_1 = Yarte_Two_Sided(<0, 0, 0>, <0.1, 0.1, 0.1>, <0.3, 0.3, 0.3>, <0, 0, 0.2>, <0, 0, 0.8>, <0, 0, 0>, 20, 0, 0.9, 1.5)

#declare Mesh_1_File = "flat.pmf"
#declare Mesh_1_Vertices = array[8] {
    <0, 0, 0>,
    <1, 0, 0>,
    <1, 1, 0>,
    <0, 1, 0>,
    <1.5, 0.5, 0>,
    <2, 0, 0>,
    <2, 1, 0>,
    <0.5, 1.5, 0>
}
#declare Mesh_1_Faces = array[15] {
    4, 0, 1, 2, 3,
    5, 1, 5, 6, 2, 4,
    3, 3, 2, 7
}

#declare Mesh_2_File = "smooth.pmf"
#declare Mesh_2_Vertices = array[3] {
    <0, 0, 0>,
    <1, 0, 0.25>,
    <0, 1, 0.25>
}
#declare Mesh_2_Faces = array[4] {
    3, 0, 1, 2
}
#declare Mesh_2_Normals = array[2] {
    <-0.25, 0, 1>,
    <0, -0.25, 2>
}
#declare Mesh_2_Face_Normals = array[3] {
    0, 1, 1
}

Yarte_Camera(<0, 1, 6>, <0, 0, 0>, <0, 1, 0>, 45, 45)
background { rgb <0, 0, 0>*Exposure }

// light, line 4
light_source { <5, 9, 7>*World_Scale rgb 1*Exposure }

// mesh, line 6
union {
    Yarte_Faces(Mesh_1_Vertices, Mesh_1_Faces, 1.5, <1, 0, 0>, <0, 1, 0>, <0, 0, 1>, <-1, 0, 0>)
    material { Material_1 }
}

// mesh, line 8
#declare Axes_2 = array[3] { <0.6, 0.8, 0>, <-0.8, 0.6, 0>, <0, 0, 0> } // as written; below, the rotation nearest to them
union {
    Yarte_Faces(Mesh_1_Vertices, Mesh_1_Faces, 0.5, <0.6, 0.8, 0>, <-0.8, 0.6, 0>, <0, 0, 1>, <1, 0.5, 0>)
    material { Material_2 }
}

// mesh, line 9
object {
    Yarte_Smooth_Faces(Mesh_2_Vertices, Mesh_2_Faces, Mesh_2_Normals, Mesh_2_Face_Normals, 1, <1, 0, 0>, <0, 1, 0>, <0, 0, 1>, <0, 0, 1>)
    material { Material_2_Back_1 }
}
