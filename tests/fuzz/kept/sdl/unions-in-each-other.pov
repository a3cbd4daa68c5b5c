#declare U = sphere { 0, 1 }
#declare i = 0;
#while (i < 3000)
#declare U = union { object { U } }
#declare i = i + 1;
#end
object { U }
