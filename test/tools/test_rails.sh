#!/usr/bin/env bash
# verify of alignments in IFC 4.3 and LandXML: what files claim about their joins, and numbers that
# follow from others.
. "$(dirname "$0")/functions.sh"

# valid ARGUMENTS...: the report in JSON is as the schema says
valid() {
  "$program" verify --json "$@" >valid.json 2>err
  valid_json roads valid.json
}
# ifc FILE ENTITIES: a file with these entities
ifc() {
  printf '%s\n' "ISO-10303-21;" "HEADER;" "FILE_DESCRIPTION((''),'2;1');" "FILE_NAME('','',(''),(''),'','','');" \
    "FILE_SCHEMA(('IFC4X3_ADD2'));" "ENDSEC;" "DATA;" "$2" "ENDSEC;" "END-ISO-10303-21;" >"$1"
}
# placed ID X Y DX DY: a placement
placed() { echo "#$1=IFCAXIS2PLACEMENT2D(#${1}1,#${1}2); #${1}1=IFCCARTESIANPOINT(($2,$3)); #${1}2=IFCDIRECTION(($4,$5));"; }
# segment ID CLAIM PLACEMENT LENGTH CURVE
segment() { echo "#$1=IFCCURVESEGMENT(.$2.,#$3,IFCLENGTHMEASURE(0.),IFCLENGTHMEASURE($4),#$5);"; }
same=CONTSAMEGRADIENTSAMECURVATURE
start="#1=IFCGEOMETRICREPRESENTATIONCONTEXT(\$,'Model',3,1.E-5,#2,\$);
$(placed 2 0. 0. 1. 0.) #3=IFCLINE(#21,#4); #4=IFCVECTOR(#22,1.);"

# a line, a clothoid and an arc: two claims of one curvature hold, that of the arc before the last
# line is false
plan="$start
#5=IFCCLOTHOID(#2,200.); #6=IFCCIRCLE(#2,400.);
$(segment 10 $same 2 100. 3)
$(segment 11 $same 30 100. 5) $(placed 30 100. 0. 1. 0.)
$(segment 12 $same 31 50. 6) $(placed 31 199.843862987 4.161 0.992197667229329 0.124674733385228)
$(segment 13 DISCONTINUOUS 32 0. 3) $(placed 32 248.9355533 13.475 0.968912421710645 0.247403959254523)
#20=IFCCOMPOSITECURVE((#10,#11,#12,#13),.F.);"
ifc plan.ifc "$plan"
run 1 verify plan.ifc && says out "IFCCOMPOSITECURVE #20, #10 - #11 (line 11): horizontal $same, gap 0, kink 0 rad, curvature jump 0" \
  "#11 - #12 (line 12): horizontal $same, gap 0.001019, kink " "not one position" "not one position, not one curvature" \
  "horizontal claims: 3 of one position, 2 false; 3 of one direction, 0 false; 3 of one curvature, 1 false" "2 of them not what is claimed"
run 1 verify --gap 0.01 plan.ifc && says out "3 of one position, 0 false" "3 of one curvature, 1 false"
run 0 verify --gap 0.01 --require G1 plan.ifc && lacks out "of one curvature"
run 0 verify --gap 0.01 --curvature 0.0025 plan.ifc
run 1 verify --gap 0.01 --curvature 0.00249 plan.ifc
run 1 verify --json plan.ifc && says out '"kind":"horizontal","curve":"IFCCOMPOSITECURVE #20","place":"#10 - #11"' '"same_point":true' \
  '"curvature":{"claims":3,"false":1,"undecided":0}'
run 1 verify --format sarif plan.ifc && says out '"startLine":12' '"gap"'
sed 's/\.CONTSAMEGRADIENTSAMECURVATURE\./.DISCONTINUOUS./' plan.ifc >silent.ifc
run 0 verify silent.ifc && lacks out "claims:" # nothing is claimed

# headings just above and below pi: the official rule takes the difference for a full turn
ifc wrap.ifc "$start $(segment 10 CONTSAMEGRADIENT 30 10. 3) $(placed 30 0. 0. -1. 1.E-13)
$(segment 11 DISCONTINUOUS 31 0. 3) $(placed 31 -10. 0. -1. -1.E-13) #20=IFCCOMPOSITECURVE((#10,#11),.F.);"
run 0 verify wrap.ifc && says out "kink at most 2.002e-13 rad"

# a parabola in the profile, over its parameter and over its length; the claim of one curvature is
# false; an arc by its angle
parabola="$start #5=IFCPOLYNOMIALCURVE(#2,(0.,1.),(0.,0.,0.001),\$);
$(segment 10 $same 2 100. 3)
#11=IFCCURVESEGMENT(.CONTSAMEGRADIENT.,#30,IFCPARAMETERVALUE(0.),IFCPARAMETERVALUE(100.),#5); $(placed 30 100. 0. 1. 0.)
$(segment 12 DISCONTINUOUS 31 0. 3) $(placed 31 200. 10. 1. 0.2)"
ifc profile.ifc "$parabola #20=IFCGRADIENTCURVE((#10,#11,#12),.F.,#21,\$);"
run 1 verify profile.ifc && says out "vertical $same, gap 0, kink 0 rad, curvature jump 0.002 - not one curvature" \
  "#11 - #12" "gap 0, kink 0 rad" "2 of one direction, 0 false; 1 of one curvature, 1 false"
ifc length.ifc "$(sed 's/IFCPARAMETERVALUE(100.)/IFCLENGTHMEASURE(100.662718)/' <<<"$parabola") #20=IFCGRADIENTCURVE((#10,#11,#12),.F.,#21,\$);"
run 1 verify --curvature 1 --gap 0.000001 length.ifc
run 0 verify --curvature 1 --gap 0.0001 length.ifc
ifc degrees.ifc "$start #5=IFCCIRCLE(#2,100.); #40=IFCUNITASSIGNMENT((#41)); #41=IFCCONVERSIONBASEDUNIT(#42,.PLANEANGLEUNIT.,'DEGREE',#43);
#43=IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE(0.0174532925199433),#44);
#10=IFCCURVESEGMENT(.CONTSAMEGRADIENT.,#2,IFCPARAMETERVALUE(0.),IFCPARAMETERVALUE(-90.),#5);
$(segment 11 DISCONTINUOUS 31 0. 3) $(placed 31 100. -100. 0. -1.) #20=IFCCOMPOSITECURVE((#10,#11),.F.);"
run 0 verify degrees.ifc

# cant: a clothoid is a linear change over its length
ifc cant.ifc "$start #5=IFCCLOTHOID(#2,70.7106692672674);
$(segment 10 CONTSAMEGRADIENT 30 49.999993741124 5) #30=IFCAXIS2PLACEMENT3D(#301,\$,#302); #301=IFCCARTESIANPOINT((400.,0.,0.));
#302=IFCDIRECTION((9.99950003737172E-1,9.99950128908449E-3,0.));
$(segment 11 DISCONTINUOUS 31 10. 3) #31=IFCAXIS2PLACEMENT3D(#311,\$,#312); #311=IFCCARTESIANPOINT((449.999993741124,5.E-1,0.));
#312=IFCDIRECTION((1.,0.,0.)); #20=IFCSEGMENTEDREFERENCECURVE((#10,#11),.F.,#21,\$);"
run 1 verify cant.ifc && says out "cant CONTSAMEGRADIENT, gap " "kink 0.01 rad" "not one direction" "1 of one position, 0 false"

# by a cosine a change of 0.1 over 100, whose second derivative is pi^2 / 200000 at the end; by a
# sine, whose slope is that of the linear change, up to the digits
spiral_cant() { # FILE SPIRAL END
  ifc "$1" "$start #5=$2; $(segment 10 $same 30 100. 5) #30=IFCAXIS2PLACEMENT3D(#301,\$,#302); #301=IFCCARTESIANPOINT((400.,0.,0.)); #302=IFCDIRECTION((1.,0.,0.));
$(segment 11 DISCONTINUOUS 31 10. 3) #31=IFCAXIS2PLACEMENT3D(#311,\$,#302); #311=IFCCARTESIANPOINT((500.,$3,0.)); #20=IFCSEGMENTEDREFERENCECURVE((#10,#11),.F.,#21,\$);"
}
spiral_cant cosine.ifc "IFCCOSINESPIRAL(#2,-2000.,2000.)" 0.1
run 1 verify cosine.ifc && says out "gap 0, kink 0 rad, curvature jump 4.935e-05 - not one curvature"
run 0 verify --curvature 0.0000493481 cosine.ifc && run 1 verify --curvature 0.000049348 cosine.ifc
spiral_cant cosine.ifc "IFCCOSINESPIRAL(#2,-2000.,2000.)" 0.1001
run 1 verify --require G1 cosine.ifc && says out "gap 0.0001, kink 0 rad"
spiral_cant sine.ifc "IFCSINESPIRAL(#2,-6283.18530717959,316.227766016838,\$)" 0.1
run 0 verify sine.ifc && says out "gap 4.225e-17, kink at most "
spiral_cant sine.ifc "IFCSINESPIRAL(#2,-6283.18530717959,-316.227766016838,\$)" -0.1
run 1 verify sine.ifc && says out "kink 0.002 rad" "1 of one position, 0 false"

# a cubic backwards by an arc length: v = t^2 / 10 from 0 to -3, where it has run 3.171
ifc backwards.ifc "$start #5=IFCPOLYNOMIALCURVE(#2,(0.,1.),(0.,0.,0.1),\$); $(segment 10 CONTSAMEGRADIENT 30 -3.171347815 5) $(placed 30 5. 6. 0. 1.)
$(segment 11 DISCONTINUOUS 31 0. 3) $(placed 31 5.9 9. 0.6 1.) #20=IFCCOMPOSITECURVE((#10,#11),.F.);"
run 0 verify --gap 0.00001 --kink 0.00001 backwards.ifc

# v = t^2 / 10 from t = 1 to t = 3, by arc lengths, turned so that it starts along the x-axis
ifc inner.ifc "$start #5=IFCPOLYNOMIALCURVE(#2,(0.,1.),(7.,0.,0.1),\$); #10=IFCCURVESEGMENT(.$same.,#30,IFCLENGTHMEASURE(1.0066272272),IFCLENGTHMEASURE(2.1647205881),#5);
$(placed 30 5. 6. 1. 0.) $(segment 11 DISCONTINUOUS 31 9. 6) $(placed 31 7.1180542595 6.3922322703 1.12 0.4) #6=IFCCIRCLE(#2,7.93);
#20=IFCGRADIENTCURVE((#10,#11),.F.,#21,\$);"
run 0 verify --kink 0.000000001 --curvature 0.001 inner.ifc && run 1 verify --kink 0.000000000001 --curvature 0.000001 inner.ifc && says out "curvature jump 1.504e-06 - not one direction, not one curvature"

# parts of spirals and graphs from a place on, forwards and backwards, against 30 digits of mpmath:
# the end is met by a line, so that the jump is the curvature there
part() { # CURVE START LENGTH X Y COSINE SINE JUMP
  ifc part.ifc "$start #5=$1; #10=IFCCURVESEGMENT(.CONTSAMEGRADIENT.,#30,IFCLENGTHMEASURE($2),IFCLENGTHMEASURE($3),#5);
$(placed 30 5. 6. 1. 0.) $(segment 11 DISCONTINUOUS 31 0. 3) $(placed 31 "$4" "$5" "$6" "$7") #20=IFC${9:-COMPOSITE}CURVE((#10,#11),.F.,#21,\$);"
  run 0 verify --gap 0.000000000001 --kink 0.000000000001 part.ifc && says out "curvature jump $8"
}
wave="IFCCOSINESPIRAL(#2,400.,500.)"
part "$wave" 30. 100. 104.766536666986768773 12.5340709643017652239 0.99746343686985452941 0.07118070038836178649 0.0005305
part "$wave" 30. -100. 102.589320092294688907 -13.195669892335190377 0.94644373499448678726 -0.3228687914458219455 0.0005305
wave="IFCSINESPIRAL(#2,700.,300.,1000.)"
part "$wave" 30. 100. 104.595726562375628599 13.7992008244678759903 0.98221347211534184887 0.18776766280466021791 0.003803
part "$wave" 30. -100. 104.833648955999804594 0.48604590536036983194 0.99697683312750853116 -0.0776993835692665442 0.001581
graph="IFCPOLYNOMIALCURVE(#2,(0.,1.),(3.,-0.2,0.1,0.01),\$)"
part "$graph" -1. 3. 7.82936550919339880814 6.81533690636001063914 0.79455138039609007052 0.60719692350230808424 0.277 GRADIENT
part "$graph" 2. -3. 7.74314633213438920377 4.92984503179045094611 0.79455138039609007052 -0.6071969235023080842 0.1181 GRADIENT
part "$graph" 2. -1. 5.98723290203149795363 5.86202424253515440333 0.96250456299523011846 -0.2712654902735714676 0.2593 GRADIENT
part "$graph" -1. -2. 6.99175276834146083046 5.83580834530120469900 0.99113964464190476311 -0.1328239617656345424 0.02326 GRADIENT
part "$graph" -3. 2. 6.99591371709443460311 6.10181563525745264033 0.99113964464190476311 0.13282396176563454240 0.1181 GRADIENT
part "IFCCOSINESPIRAL(#2,-2000.,2000.)" 30. 100. 105. 6.0587785252292473129 1. -0.001270800923078815083 "" SEGMENTEDREFERENCE
part "IFCSINESPIRAL(#2,-6283.,300.,\$)" 30. -100. 105. 6.1111111111111111111 1. 0.0014201372194551296 "" SEGMENTEDREFERENCE

# the design: transitions, a profile, cant; which need not claim anything
nested() { echo "#$1=IFCRELNESTS('',\$,\$,\$,#$2,($3));"; }
design() { echo "#$1=IFCALIGNMENTSEGMENT('',\$,\$,\$,\$,\$,\$,#$2);"; }
ifc design.ifc "$start #50=IFCALIGNMENTHORIZONTAL('',\$,\$,\$,\$,\$,\$); $(nested 51 50 '#52,#53,#54') $(design 52 62) $(design 53 63) $(design 54 64)
#62=IFCALIGNMENTHORIZONTALSEGMENT(\$,\$,#21,0.,0.,0.,100.,\$,.LINE.);
#63=IFCALIGNMENTHORIZONTALSEGMENT(\$,\$,#73,0.,0.,400.,100.,\$,.CLOTHOID.); #73=IFCCARTESIANPOINT((100.,0.));
#64=IFCALIGNMENTHORIZONTALSEGMENT(\$,\$,#74,0.125,400.,400.,50.,\$,.CIRCULARARC.); #74=IFCCARTESIANPOINT((199.843862987,4.162018));
#80=IFCALIGNMENTVERTICAL('',\$,\$,\$,\$,\$,\$);
$(nested 81 80 '#82,#83,#84,#85,#86,#87') $(design 82 92) $(design 83 93) $(design 84 94) $(design 85 95) $(design 86 96) $(design 87 97)
#92=IFCALIGNMENTVERTICALSEGMENT(\$,\$,0.,100.,10.,0.01,0.01,\$,.CONSTANTGRADIENT.);
#93=IFCALIGNMENTVERTICALSEGMENT(\$,\$,100.,50.,11.,0.01,-0.01,\$,.PARABOLICARC.);
#94=IFCALIGNMENTVERTICALSEGMENT(\$,\$,150.,50.,11.,-0.01,0.,5000.249993750,.CIRCULARARC.);
#95=IFCALIGNMENTVERTICALSEGMENT(\$,\$,200.,50.,10.75000625,0.,-0.01,5000.249993750,.CIRCULARARC.);
#96=IFCALIGNMENTVERTICALSEGMENT(\$,\$,250.,50.,10.5000125,-0.01,0.,\$,.CLOTHOID.);
#97=IFCALIGNMENTVERTICALSEGMENT(\$,\$,300.,50.,10.,0.,0.01,\$,.PARABOLICARC.);"
run 1 verify --gap 0.00001 design.ifc && says out "design horizontal, gap 0, kink 0 rad, curvature jump 0" "design vertical, gap 0, kink 0 rad, curvature jump 0.0003999" \
  "#93 - #94 (line 16): design vertical, gap 0, kink 0 rad, curvature jump 0.0005999" "#94 - #95 (line 17): design vertical, gap 3.125e-10" \
  "curvature jump 0.0004" "#96 - #97 (line 19): design vertical, not covered: a vertical clothoid between two curves, so that nothing tells at which end it is straight"
sed 's/5000.249993750,.CIRC/5000.35,.CIRC/' design.ifc >arc.ifc && run 1 verify --allow-uncovered --gap 0.0001 arc.ifc && says out "#94 - #95 (line 17): design vertical, gap 0.001" "not one position"
sed 's/5000.249993750,.CIRC/\$,.CIRC/' design.ifc >arc.ifc && run 1 verify arc.ifc && says out "#93 - #94 (line 16): design vertical, gap at most 1" "#94 - #95 (line 17): design vertical, gap 3.125e-10, kink 0 rad, curvature jump 0.0004"
sed '/#94=/s/-0.01,0.,5000.249993750/0.03,-0.05,$/; /#95=/s/10.75000625/10.5007986424354257242014/' design.ifc >arc.ifc && run 1 verify --gap 1.E-20 arc.ifc && says out "#94 - #95 (line 17): design vertical, gap 4.023e-24"
sed -i '/#95=/s/10.5007/10.5008/' arc.ifc && run 1 verify arc.ifc && says out "gap 0.0001, kink 0.04996 rad, curvature jump 0.001398 - not one position"
run 1 verify --allow-uncovered --require G2 --gap 0.00001 design.ifc && says out "not one curvature"
run 0 verify --allow-uncovered --gap 0.00001 design.ifc
# vertical clothoids from a gradient into an arc, by the distance, and back, by the radius, against
# 40 digits of mpmath; what lies beside them tells which end is straight
vertical() { echo "#$1=IFCALIGNMENTVERTICALSEGMENT(\$,\$,$2,$3,$4,$5,$6,$7,.$8.);"; }
clothoids() { # FIRST
  ifc clothoids.ifc "$start #80=IFCALIGNMENTVERTICAL('',\$,\$,\$,\$,\$,\$); $(nested 81 80 '#82,#83,#84,#85,#86') $(design 82 92) $(design 83 93) $(design 84 94) $(design 85 95) $(design 86 96)
$(vertical 92 0. 100. 10. 0.01 0.01 \$ "$1")
$(vertical 93 100. 50. 11. 0.01 -0.01 \$ CLOTHOID)
$(vertical 94 150. 24.98517705012141249381 11.16666285732780638712 -0.01 -0.03 1250.07083175371183850149 CIRCULARARC)
$(vertical 95 174.98517705012141249381 49.87362521831144357482 10.66700926170878349440 -0.03 -0.05 1250.07083175371183850149 CLOTHOID)
$(vertical 96 224.85880226843285606863 100. 8.50599967526591554764 -0.05 -0.05 \$ CONSTANTGRADIENT)"
}
clothoids CONSTANTGRADIENT
run 0 verify --require G2 --gap 1.E-18 --kink 1.E-18 --curvature 1.E-18 clothoids.ifc && says out "curvature jump 0" "every join is what is claimed up to G2, proved"
sed 's/-0.03,1250.0/-0.03,1250.1/' clothoids.ifc >other.ifc && run 1 verify --require G2 other.ifc && says out "#93 - #94 (line 11): design vertical, gap 4.07e-21, kink 0 rad, curvature jump 6.399e-08" "#94 - #95 (line 12): design vertical, gap 0.001999" "not one position"
sed '/#93=/s/-0.01,.,/-0.01,1250.070831753711838501,/' clothoids.ifc >radius.ifc && run 0 verify --require G2 --gap 1.E-15 --curvature 1.E-18 radius.ifc
sed -i 's/1250.070831753711838501,.CL/-1300.,.CL/' radius.ifc && run 1 verify radius.ifc && says out "#93 - #94 (line 11): design vertical, gap 1.997"
clothoids CIRCULARARC && run 1 verify clothoids.ifc && says out "#92 - #93 (line 10): design vertical, not covered: a vertical arc between equal gradients" "#93 - #94 (line 11): design vertical, not covered: a vertical clothoid between two curves"
sed 's/,-0.01,-0.03,1250.[0-9]*,.CIRCULARARC./,-0.03,-0.03,$,.CONSTANTGRADIENT./; /#92=/s/CIRCULARARC/CONSTANTGRADIENT/' clothoids.ifc >between.ifc && run 2 verify between.ifc && says out "not covered: a vertical clothoid between two gradients"
clothoids CONSTANTGRADIENT && sed '/#96=/{s/,100\.,/,0.,/; s/CONSTANTGRADIENT/CLOTHOID/}' clothoids.ifc >last.ifc && run 0 verify --gap 1.E-18 --kink 1.E-18 last.ifc && says out "#95 - #96 (line 13): design vertical, gap 3.715e-21, kink 0 rad, no curvature"
# steep ones, straight at the start and at the end: the rise is that of mpmath
steep() { # BEFORE AFTER RISE
  ifc steep.ifc "$start #80=IFCALIGNMENTVERTICAL('',\$,\$,\$,\$,\$,\$); $(nested 81 80 '#82,#83,#84') $(design 82 92) $(design 83 93) $(design 84 94) $(vertical 92 0. 10. 0. 0.5 0.5 \$ "$1")
$(vertical 93 10. 50. 5. 0.5 -2. \$ CLOTHOID) $(vertical 94 60. 10. "$3" -2. -2. \$ "$2")"
  run 0 verify --gap 1.E-18 --kink 1.E-18 steep.ifc
}
steep CONSTANTGRADIENT PARABOLICARC 2.582015206065649349154 && says out "#93 - #94 (line 10): design vertical, gap 1.964e-22, kink 0 rad, curvature jump 0.05614"
steep PARABOLICARC CONSTANTGRADIENT -28.854133505638779640210 && says out "curvature jump 0.04654"

# y = x^3 / (6 R L) from either end: what turns into the arc, and back out of it
ifc cubic.ifc "$start #50=IFCALIGNMENTHORIZONTAL('',\$,\$,\$,\$,\$,\$); $(nested 51 50 '#52,#53,#54') $(design 52 62) $(design 53 63) $(design 54 64)
#62=IFCALIGNMENTHORIZONTALSEGMENT(\$,\$,#21,0.,0.,400.,100.,\$,.CUBIC.);
#63=IFCALIGNMENTHORIZONTALSEGMENT(\$,\$,#73,0.124354994547,400.,0.,100.,\$,.CUBIC.); #73=IFCCARTESIANPOINT((100.,4.16666666667));
#64=IFCALIGNMENTHORIZONTALSEGMENT(\$,\$,#74,0.248709989094,0.,0.,50.,\$,.LINE.); #74=IFCCARTESIANPOINT((197.948717949,24.743589744));"
run 0 verify --gap 0.00001 --kink 0.000000001 --require G1 cubic.ifc && says out "2 of one position, 0 false"
sed '/#96=/!s/\.CLOTHOID\./.BLOSSCURVE./' design.ifc >bloss.ifc
run 1 verify --allow-uncovered --gap 0.01 bloss.ifc && says out "gap 0.4165" # another curve, another end

# what is not covered, and what is refused
ifc other.ifc "$start #5=IFCBSPLINECURVE(); $(segment 10 CONTINUOUS 2 1. 5) $(segment 11 DISCONTINUOUS 2 0. 3) #20=IFCCOMPOSITECURVE((#10,#11),.F.);"
run 2 verify other.ifc && says out "not covered: a segment of IFCBSPLINECURVE"
sed 's/IFCLENGTHMEASURE(100.)/IFCLENGTHMEASURE(NAN)/' plan.ifc >nan.ifc && refused "nan.ifc:11: IFCCURVESEGMENT: " verify nan.ifc
sed 's/#31,IFCL/#99,IFCL/' plan.ifc >lost.ifc && refused "lost.ifc:13: #99 is referred to, and does not exist" verify lost.ifc
head -12 plan.ifc >cut.ifc && refused "the file ends before END-ISO-10303-21;" verify cut.ifc
ifc twice.ifc "$plan #20=IFCLINE(#21,#4);" && refused "#20 is given twice" verify twice.ifc
printf 'ISO-10303-21;DATA;#1=A(%s);ENDSEC;END-ISO-10303-21;' "$(printf '(%.0s' {1..70})$(printf ')%.0s' {1..70})" >deep.ifc
refused "the schema '' is none of IFC" verify deep.ifc
sed 's/IFCCIRCLE(#2,400.)/IFCCIRCLE(#2,1.E-9)/' plan.ifc >wild.ifc && run 1 verify wild.ifc && says out "turns by more than 20000 radians"
refused "alignments (.ifc, LandXML) and other files cannot be verified together" verify plan.ifc "$S"
refused "not for alignments" verify --closed plan.ifc
refused "of alignments G0, G1 and G2 are decided" verify --require G3 plan.ifc

# LandXML: the same point, direction, angle and constant twice; 1.037e-6 between two directions
landxml() {
  cat <<END
<?xml version="1.0"?>
<LandXML xmlns="http://www.landxml.org/schema/LandXML-1.2" version="1.2">
<Units><Metric angularUnit="$1" directionUnit="$1"/></Units>
<Alignments><Alignment name="Track A"><CoordGeom>
<Line dir="$2" length="50"><Start>100 200</Start><End>143.87912809452 223.97127693021</End></Line>
<Spiral length="40" radiusStart="INF" radiusEnd="400" rot="cw" spiType="clothoid" theta="$5" constant="126.491106406735" dirStart="$2" dirEnd="$3">
<Start>143.87912809452 223.97127693021</Start><End>178.6540958044 243.7284553493</End></Spiral>
<Curve rot="cw" radius="400" length="20" dirStart="$4"><Start>178.6540958044 243.7284553493</Start><End>195.4361823 254.6040356</End></Curve>
</CoordGeom></Alignment></Alignments></LandXML>
END
}
landxml radians 0.5 0.55 0.550001037 0.05 >track.xml
run 0 verify track.xml && says out "Alignment Track A, Line 1 - Spiral 2 (line 5): horizontal, gap 0, kink 0 rad, curvature jump 0" \
  "Spiral 2 - Curve 3 (line 6): horizontal, gap 0, kink 1.037e-06 rad" "theta, theta off by 0" "constant, constant off by at most 1.8" "3 declared end"
run 1 verify --kink 0.000001 track.xml && says out "not one direction"
run 0 verify --kink 0.000001037 track.xml
run 0 verify --require G2 track.xml
sed 's/radius="400"/radius="399"/' track.xml >radius.xml
run 1 verify --gap 1 --require G2 radius.xml && says out "curvature jump 6.266e-06 - not one curvature"
landxml "decimal  degrees" 28.64788975654116 31.51267873219528 31.512738147638 2.864788975654116 >degrees.xml
run 0 verify degrees.xml && says out "horizontal, gap 0, kink 1.037e-06 rad"
sed 's/theta="0.05"/theta="0.06"/; s/constant="126/constant="127/' track.xml >wrong.xml
run 1 verify wrong.xml && says out "theta off by 0.01 - not one theta" "constant off by 1 - not one constant"
sed 's/rot="cw"/rot="ccw"/' track.xml >turned.xml && run 1 verify turned.xml && says out "declared end, gap 1.33"
sed 's/clothoid/radioid/' track.xml >radioid.xml && run 1 verify radioid.xml && says out "not covered: a spiral of the type 'radioid'"
sed 's,<Start>178.6540958044 243.7284553493</Start>,<Start pntRef="7"/>,' track.xml >elsewhere.xml
run 1 verify elsewhere.xml && says out "not covered: an element without start or end" "points without coordinates, of which there are 1"
sed 's,</LandXML>,<CgPoints><CgPoint name="7">178.6540958044 243.7284553493 3</CgPoint></CgPoints></LandXML>,' elsewhere.xml >named.xml
run 0 verify named.xml && says out "Spiral 2 - Curve 3 (line 6): horizontal, gap 0, kink 1.037e-06 rad"
sed 's/name="Track A"/& length="110.001"/; s/radius="400"/& delta="0.05"/' track.xml >sum.xml
run 0 verify sum.xml && says out "length, length off by 0.001" "delta, delta off by 0"
sed 's/110.001/110.0011/; s/delta="0.05"/delta="0.06"/' sum.xml >wrong.xml && run 1 verify wrong.xml && says out "not one length" "delta off by 0.01 - not one delta"
# a line and a curve of points alone, whose directions follow from them; a radius of 5
points() { # CENTRE RADIUS
  printf '<LandXML><Units><Metric angularUnit="radians"/></Units><Alignment><CoordGeom><Line><Start>0 0</Start><End>10 0</End></Line>\n%s<Start>10 0</Start><Center>%s</Center><End>14 2</End></Curve>\n</CoordGeom></Alignment></LandXML>' \
    "<Curve rot=\"cw\" radius=\"$2\">" "$1" >points.xml
}
points "10 5" 5 && run 0 verify points.xml && says out "Line 1 - Curve 2 (line 1): horizontal, gap 0, kink 0 rad" "Curve 2, Start (line 2): radius, radius off by 0" && lacks out "declared end"
points "10 5" 5.25 && run 1 verify points.xml && says out "Curve 2, End (line 2): radius, radius off by 0.25 - not one radius"
points "11 5" 5 && run 1 verify points.xml && says out "kink 0.1974 rad" "Start (line 2): radius, radius off by 0.09902"
# without a radius: the distances from the centre, which are 5, and roots of 10
sed 's/ radius="5"//' points.xml >centre.xml && run 1 verify centre.xml && says out "radius, radius off by 0.8564 - not one radius"
points "10 5" 5 && sed 's/ radius="5"//' points.xml >centre.xml && run 0 verify centre.xml && says out "Line 1 - Curve 2 (line 1): horizontal, gap 0, kink 0 rad, curvature jump 0.2" "Curve 2, Start and End (line 2): radius, radius off by 0"
about() { # CENTRE
  printf '<!DOCTYPE LandXML [<!ENTITY north "3">]><LandXML><Units><Metric angularUnit="radians"/></Units><Alignment><CoordGeom>
<Curve rot="ccw" length="2.932364952267465556" delta="0.92729521800161223243"><Start>1 &north;</Start><Center>0 0</Center><End>3 1</End></Curve>
<Curve rot="ccw"><Start>3 1</Start><Center>%s</Center><End>3 -1</End></Curve></CoordGeom></Alignment></LandXML>' "$1" >about.xml
}
about "0 0" && run 0 verify --require G2 --gap 1e-13 --kink 1e-13 --curvature 0 about.xml && says out "Curve 1 - Curve 2 (line 2): horizontal, gap 0, kink 0 rad, curvature jump 0" "declared end, gap " "delta off by " && valid about.xml
about "0 0.001" && run 1 verify --require G2 about.xml && says out "kink 0.0003 rad, curvature jump " "radius off by 0.0006325"
laughs LandXML >laughs.xml && refused "limit on input amplification" verify laughs.xml
# vertical curves, which must not overlap on the gradient between them
profile() { sed 's,</Alignment>,<Profile><ProfAlign name="P"><PVI>0 10</PVI><ParaCurve length="60">100 12</ParaCurve><UnsymParaCurve lengthIn="'"$1"'" lengthOut="20">200 11</UnsymParaCurve>'"${2:-}"'<PVI>300 10</PVI></ProfAlign></Profile>&,' track.xml; }
profile 70 >profile.xml && run 0 verify profile.xml && says out "ParaCurve 2 - UnsymParaCurve 3 (line 9): profile, overlap off by 0"
profile 70.5 >profile.xml && run 1 verify profile.xml && says out "overlap off by 0.5 - not one overlap"
# an arc reaches R tan(d / 2) along its tangents: 9.998000599800069974809 over the distance
circle() { # LENGTH STATION
  sed 's,</Alignment>,<Profile><ProfAlign><PVI>0 10</PVI><CircCurve length="'"$1"'" radius="500">100 8</CircCurve><ParaCurve length="40">'"$2"'</ParaCurve><PVI>300 12</PVI></ProfAlign></Profile>&,' track.xml >profile.xml
}
circle 19.99733397315053306 "200 10" && run 0 verify profile.xml && says out "CircCurve 2 (line 9): arc length, arc length off by at most" "CircCurve 2 - ParaCurve 3 (line 9): profile, overlap off by 0"
circle 19.996001199600139949618 "200 10" && run 0 verify profile.xml
circle 19.99 "200 10" && run 1 verify profile.xml && says out "arc length off by 0.006001 - not one arc length"
circle 19.996 "129.998 8.59996" && run 0 verify profile.xml && says out "overlap off by 5.998e-07"
circle 19.996 "129.996 8.59992" && run 1 verify profile.xml && says out "overlap off by 0.002001 - not one overlap"
sed 's/ radius="500"//' profile.xml >bare.xml && run 1 verify bare.xml && says out "not covered: 2 joins, an arc without a radius"
sed 's/>143.879/>x143.879/' track.xml >bad.xml && refused "bad.xml:5: not a number: 'x143.87912809452'" verify bad.xml
sed 's/radians/gon/g' track.xml >unit.xml && refused "the unit of angles 'gon'" verify unit.xml

# --max-curvature: a curvature that only rises or falls is largest at an end
bent() { # CODE BOUND LENGTH CURVE TEXT...
  ifc bent.ifc "$start #5=$4; $(segment 10 DISCONTINUOUS 2 "$3" 5) $(segment 11 DISCONTINUOUS 2 0. 3) #20=IFCCOMPOSITECURVE((#10,#11),.F.);"
  run "$1" verify bent.ifc --max-curvature "$2" && says out "${@:5}" && valid bent.ifc --max-curvature "$2"
}
bent 0 1/400 100. "IFCCIRCLE(#2,400.)" "#10 (line 9): bend IFCCIRCLE, curvature 0.0025" "every join and every piece of the plan is what is claimed, or bent by at most the curvature 1/400, proved"
bent 1 0.00249 -100. "IFCCIRCLE(#2,400.)" "not bent by at most the curvature 0.00249" "1 of them" "2 bend (1 bent too much)"
bent 0 1/400 100. "IFCCLOTHOID(#2,200.)" "curvature 0.0025 at its end"
bent 0 0.1 10. "IFCSECONDORDERPOLYNOMIALSPIRAL(#2,10.,\$,\$)" "curvature 0.1 at its end"
bent 1 1 30. "IFCSECONDORDERPOLYNOMIALSPIRAL(#2,10.,-5.,\$)" "not covered: a curvature that does not only rise or only fall"
bent 0 0.0045 100. "IFCCOSINESPIRAL(#2,400.,500.)" "curvature 0.0045 at its start"
bent 1 0.0044999 -100. "IFCCOSINESPIRAL(#2,400.,500.)" "curvature 0.0045 at its start" "(1 bent too much)"
bent 0 1/100 100. "IFCSINESPIRAL(#2,-6283.18530717959,100.,\$)" "curvature 0.01 at its end"
bent 1 1 100. "IFCSINESPIRAL(#2,-600.,100.,\$)" "does not only rise or only fall"
bent 0 1 3. "IFCPOLYNOMIALCURVE(#2,(0.,1.),(0.,0.,0.5),\$)" "IFCPOLYNOMIALCURVE, bent by at most the curvature 1"
bent 1 0.999 -3. "IFCPOLYNOMIALCURVE(#2,(0.,1.),(0.,0.,0.5),\$)" "curvature 1 at u = 0"
run 0 verify track.xml --min-radius 400 && run 1 verify track.xml --min-radius 400.001 --json && says out '"kind":"bend","curve":"Alignment' '"met":false'
run 0 verify --allow-uncovered --gap 1 design.ifc --min-radius 100 && says out "design horizontal" "bend CLOTHOID, curvature"

valid plan.ifc && valid design.ifc cosine.ifc backwards.ifc && valid track.xml profile.xml elsewhere.xml wrong.xml
# numbers beyond those of floating-point numbers
sed 's/constant="[0-9.]*"/constant="1e400"/' track.xml >huge.xml
run 1 verify huge.xml && says out "not covered: a number beyond those of floating-point numbers"
sed 's/100.,0./1.E400,0./' plan.ifc >huge.ifc && run 1 verify huge.ifc && says out "gap more than 1.798e+308" "not one position"
sed 's/0.,0.,0.001/0.,1.E300,0.001/; s/IFCPARAMETERVALUE(100.)/IFCLENGTHMEASURE(100.)/' profile.ifc >steep.ifc
valid huge.ifc
run 1 verify --max-work 1000000 steep.ifc && says out "more than 1000000 steps of work"
