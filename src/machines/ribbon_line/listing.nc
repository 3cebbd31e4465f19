Variable calculation macro program: P9100
(#100----Spindle speed S command (setting))
#101-----Spindle reduction ratio (setting)
#102------Main spindle pressure roller diameter (setting)
#2000----Actual spindle speed (R/M) (PLC to NC)
#105------ Main spindle unwinding wheel linear velocity (calculation)
#107-----Pitch: X-axis single-pitch distance (setting)
#109----Number of Printheads (Setting)
#111-----Diameter of the dot printing roller (setting)
#110-----Y-axis movement distance of the dot print axis
#1000-----Interpolation axis linkage speed)
N5 #2000=#100* #1033/100-------Actual spindle speed (R/M)
N10 #105 = (3.14 * #102) / #101 * #2000 ------ Main shaft unwinding pressure roller linear speed
N20 #110=(3.14*#111) / #109------------Calculate the distance the dot print roller moves.
N30
—Calculate linkage speed
N100 S#100 M3
N200 G91 G01 X#107. Y#110 F#115
