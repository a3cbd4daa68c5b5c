// Glass that POV-Ray tints, by filter, by transmit and by both, with total internal reflection and shadows on shadows.
// Large, since POV-Ray's tolerances are absolute.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 adc_bailout 0 }
camera {
    location <37, 311, -930>
    direction <-0.023490203834118466, -0.3132027177882462, 0.9493957382956213>
    right <1.1996328606611812, -0.0, 0.029681637789555>
    up <-0.006972277218071206, 0.8547176648646883, 0.2817962042303778>
}
background { rgb <0.2, 0.26, 0.35> }
light_source { <570, 890, -430> rgb 0.8 }
light_source { <-490, 770, -590> rgb <0.3, 0.27, 0.22> }

polygon {
    5, <-830, -137, -710>, <870, -137, -710>, <870, -137, 790>, <-830, -137, 790>, <-830, -137, -710>
    pigment { rgb <0.6, 0.57, 0.5> }
    finish { ambient 0.1 diffuse 0.7 }
}
box {
    <-68, -70, -64>, <68, 70, 64>
    pigment { rgbf <0.3, 0.9, 0.4, 0.8> }
    finish { ambient 0 diffuse 0.3 phong 0.4 phong_size 60 }
    interior { ior 1.5 }
    rotate <17, 31, 23>
    translate <121, -17, -67>
}
sphere {
    <-231, -13, -23>, 107
    pigment { rgbft <0.9, 0.2, 0.1, 0.5, 0.3> }
    finish { ambient 0 diffuse 0.3 }
    interior { ior 1.3125 }
}
sphere {
    <-113, 9, 71>, 97
    pigment { rgbt <0.4, 0.5, 0.9, 0.7> }
    finish { ambient 0 diffuse 0.4 }
    interior { ior 1.40625 }
}
