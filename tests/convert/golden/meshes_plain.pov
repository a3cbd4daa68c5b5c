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

// One texture. Exact but for these: specular colours become grey; a millionth stands in for zeros of D where A has none;
// total internal reflection has weight 1; with Ct = 1 nothing local is left.
#macro Yarte_Plain(A, D, S, N, Cr, Ct)
    #local Shown = (Ct < 1 ? 1 - Ct : 1);
    #local P = <max(D.x, min(1e-6, A.x*1e30)), max(D.y, min(1e-6, A.y*1e30)), max(D.z, min(1e-6, A.z*1e30))>;
    #local Ambient = <A.x/max(P.x, 1e-6), A.y/max(P.y, 1e-6), A.z/max(P.z, 1e-6)>;
    pigment { rgbt <P.x/Shown, P.y/Shown, P.z/Shown, Ct> }
    finish { ambient rgb Ambient*Exposure diffuse 1 phong max(S.x, S.y, S.z) phong_size N reflection { rgb Cr } }
#end

// An index of exactly 1 would pass rays on without counting a level: the nearest one that does not is used.
#macro Yarte_Interior(Ct, Index)
    #if (Ct > 0) interior { ior (abs(Index - 1) < 6e-8 ? 1 + pow(2, -23) : Index) } #end
#end

#macro Yarte_Material(A, D, S, N, Cr, Ct, Index)
    material { texture { Yarte_Plain(A, D, S, N, Cr, Ct) } Yarte_Interior(Ct, Index) }
#end

#macro Yarte_Two_Sided(A, D, S, Back_A, Back_D, Back_S, N, Cr, Ct, Index)
    material {
        texture { Yarte_Plain(A, D, S, N, Cr, Ct) }
        interior_texture { Yarte_Plain(Back_A, Back_D, Back_S, N, Cr, Ct) }
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
#declare Mesh_2 = mesh2 {
    vertex_vectors {
        3,
        <0, 0, 0>,
        <1, 0, 0.25>,
        <0, 1, 0.25>
    }
    normal_vectors {
        2,
        <-0.25, 0, 1>,
        <0, -0.25, 2>
    }
    face_indices {
        1,
        <0, 2, 1>
    }
    normal_indices {
        1,
        <0, 1, 1>
    }
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
    Mesh_2
    scale 1
    Yarte_Turn(<1, 0, 0>, <0, 1, 0>, <0, 0, 1>)
    translate <0, 0, 1>
    scale World_Scale
    material { Material_2_Back_1 }
}
