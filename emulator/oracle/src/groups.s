@ Written by generate.py; do not edit.
.syntax unified
.section .rodata.groups, "a"
.balign 4
group_and_imm:
.balign 4
.hword (.Le0 - .Lb0) / 2, 0
.Lb0:
and r5, r3, #0
.Le0:
.balign 4
.hword (.Le1 - .Lb1) / 2, 0
.Lb1:
and r3, lr, #1
.Le1:
.balign 4
.hword (.Le2 - .Lb2) / 2, 0
.Lb2:
and lr, r12, #0xff
.Le2:
.balign 4
.hword (.Le3 - .Lb3) / 2, 0
.Lb3:
and r3, lr, #0x00ab00ab
.Le3:
.balign 4
.hword (.Le4 - .Lb4) / 2, 0
.Lb4:
and r12, r12, #0xcd00cd00
.Le4:
.balign 4
.hword (.Le5 - .Lb5) / 2, 0
.Lb5:
and lr, r10, #0x5e5e5e5e
.Le5:
.balign 4
.hword (.Le6 - .Lb6) / 2, 0
.Lb6:
and r3, r11, #0x80000000
.Le6:
.balign 4
.hword (.Le7 - .Lb7) / 2, 0
.Lb7:
and r0, r0, #0xff000000
.Le7:
.balign 4
.hword (.Le8 - .Lb8) / 2, 0
.Lb8:
and r12, r9, #0x3fc00
.Le8:
.balign 4
.hword (.Le9 - .Lb9) / 2, 0
.Lb9:
and r0, r9, #0x104
.Le9:
.balign 4
.hword (.Le10 - .Lb10) / 2, 0
.Lb10:
and lr, r9, #0x7f8
.Le10:
.balign 4
.hword (.Le11 - .Lb11) / 2, 0
.Lb11:
and r9, r9, #0x000001fe
.Le11:
.balign 4
.hword (.Le12 - .Lb12) / 2, 0
.Lb12:
ands r10, r0, #0
.Le12:
.balign 4
.hword (.Le13 - .Lb13) / 2, 0
.Lb13:
ands r3, r5, #1
.Le13:
.balign 4
.hword (.Le14 - .Lb14) / 2, 0
.Lb14:
ands r3, r11, #0xff
.Le14:
.balign 4
.hword (.Le15 - .Lb15) / 2, 0
.Lb15:
ands r9, r10, #0x00ab00ab
.Le15:
.balign 4
.hword (.Le16 - .Lb16) / 2, 0
.Lb16:
ands lr, r12, #0xcd00cd00
.Le16:
.balign 4
.hword (.Le17 - .Lb17) / 2, 0
.Lb17:
ands lr, r9, #0x5e5e5e5e
.Le17:
.balign 4
.hword (.Le18 - .Lb18) / 2, 0
.Lb18:
ands r12, r5, #0x80000000
.Le18:
.balign 4
.hword (.Le19 - .Lb19) / 2, 0
.Lb19:
ands r11, r3, #0xff000000
.Le19:
.balign 4
.hword (.Le20 - .Lb20) / 2, 0
.Lb20:
ands r3, r5, #0x3fc00
.Le20:
.balign 4
.hword (.Le21 - .Lb21) / 2, 0
.Lb21:
ands r11, lr, #0x104
.Le21:
.balign 4
.hword (.Le22 - .Lb22) / 2, 0
.Lb22:
ands lr, r0, #0x7f8
.Le22:
.balign 4
.hword (.Le23 - .Lb23) / 2, 0
.Lb23:
ands r12, r5, #0x000001fe
.Le23:
.balign 4
.hword 0xffff, 0
.balign 4
group_and_reg:
.balign 4
.hword (.Le24 - .Lb24) / 2, 0
.Lb24:
and.w r9, r0, r9
.Le24:
.balign 4
.hword (.Le25 - .Lb25) / 2, 0
.Lb25:
and.w r9, r12, r11, lsl #1
.Le25:
.balign 4
.hword (.Le26 - .Lb26) / 2, 0
.Lb26:
and.w r11, lr, r10, lsl #7
.Le26:
.balign 4
.hword (.Le27 - .Lb27) / 2, 0
.Lb27:
and.w r0, r12, r5, lsl #31
.Le27:
.balign 4
.hword (.Le28 - .Lb28) / 2, 0
.Lb28:
and.w r9, r12, r0, lsr #1
.Le28:
.balign 4
.hword (.Le29 - .Lb29) / 2, 0
.Lb29:
and.w lr, r11, r9, lsr #32
.Le29:
.balign 4
.hword (.Le30 - .Lb30) / 2, 0
.Lb30:
and.w r12, lr, r11, lsr #13
.Le30:
.balign 4
.hword (.Le31 - .Lb31) / 2, 0
.Lb31:
and.w r12, r11, r0, asr #1
.Le31:
.balign 4
.hword (.Le32 - .Lb32) / 2, 0
.Lb32:
and.w r11, lr, r0, asr #32
.Le32:
.balign 4
.hword (.Le33 - .Lb33) / 2, 0
.Lb33:
and.w r9, r5, r5, asr #20
.Le33:
.balign 4
.hword (.Le34 - .Lb34) / 2, 0
.Lb34:
and.w r3, r10, r0, ror #1
.Le34:
.balign 4
.hword (.Le35 - .Lb35) / 2, 0
.Lb35:
and.w r3, r3, r0, ror #31
.Le35:
.balign 4
.hword (.Le36 - .Lb36) / 2, 0
.Lb36:
and.w lr, r0, r10, rrx
.Le36:
.balign 4
.hword (.Le37 - .Lb37) / 2, 0
.Lb37:
ands.w r9, r10, r3
.Le37:
.balign 4
.hword (.Le38 - .Lb38) / 2, 0
.Lb38:
ands.w r5, r11, r10, lsl #1
.Le38:
.balign 4
.hword (.Le39 - .Lb39) / 2, 0
.Lb39:
ands.w r3, r5, r5, lsl #7
.Le39:
.balign 4
.hword (.Le40 - .Lb40) / 2, 0
.Lb40:
ands.w r10, r5, r10, lsl #31
.Le40:
.balign 4
.hword (.Le41 - .Lb41) / 2, 0
.Lb41:
ands.w r10, lr, r11, lsr #1
.Le41:
.balign 4
.hword (.Le42 - .Lb42) / 2, 0
.Lb42:
ands.w lr, lr, r3, lsr #32
.Le42:
.balign 4
.hword (.Le43 - .Lb43) / 2, 0
.Lb43:
ands.w r0, r10, r12, lsr #13
.Le43:
.balign 4
.hword (.Le44 - .Lb44) / 2, 0
.Lb44:
ands.w r11, r12, r9, asr #1
.Le44:
.balign 4
.hword (.Le45 - .Lb45) / 2, 0
.Lb45:
ands.w r10, r3, r10, asr #32
.Le45:
.balign 4
.hword (.Le46 - .Lb46) / 2, 0
.Lb46:
ands.w r9, r12, r0, asr #20
.Le46:
.balign 4
.hword (.Le47 - .Lb47) / 2, 0
.Lb47:
ands.w r9, r0, r12, ror #1
.Le47:
.balign 4
.hword (.Le48 - .Lb48) / 2, 0
.Lb48:
ands.w r5, r0, r5, ror #31
.Le48:
.balign 4
.hword (.Le49 - .Lb49) / 2, 0
.Lb49:
ands.w lr, r12, r9, rrx
.Le49:
.balign 4
.hword 0xffff, 0
.balign 4
group_bic_imm:
.balign 4
.hword (.Le50 - .Lb50) / 2, 0
.Lb50:
bic lr, r9, #0
.Le50:
.balign 4
.hword (.Le51 - .Lb51) / 2, 0
.Lb51:
bic r12, r11, #1
.Le51:
.balign 4
.hword (.Le52 - .Lb52) / 2, 0
.Lb52:
bic r0, r10, #0xff
.Le52:
.balign 4
.hword (.Le53 - .Lb53) / 2, 0
.Lb53:
bic r9, r0, #0x00ab00ab
.Le53:
.balign 4
.hword (.Le54 - .Lb54) / 2, 0
.Lb54:
bic r3, r3, #0xcd00cd00
.Le54:
.balign 4
.hword (.Le55 - .Lb55) / 2, 0
.Lb55:
bic r10, r5, #0x5e5e5e5e
.Le55:
.balign 4
.hword (.Le56 - .Lb56) / 2, 0
.Lb56:
bic r10, r5, #0x80000000
.Le56:
.balign 4
.hword (.Le57 - .Lb57) / 2, 0
.Lb57:
bic r0, r9, #0xff000000
.Le57:
.balign 4
.hword (.Le58 - .Lb58) / 2, 0
.Lb58:
bic r5, r0, #0x3fc00
.Le58:
.balign 4
.hword (.Le59 - .Lb59) / 2, 0
.Lb59:
bic r9, r11, #0x104
.Le59:
.balign 4
.hword (.Le60 - .Lb60) / 2, 0
.Lb60:
bic r9, r12, #0x7f8
.Le60:
.balign 4
.hword (.Le61 - .Lb61) / 2, 0
.Lb61:
bic lr, r3, #0x000001fe
.Le61:
.balign 4
.hword (.Le62 - .Lb62) / 2, 0
.Lb62:
bics r10, lr, #0
.Le62:
.balign 4
.hword (.Le63 - .Lb63) / 2, 0
.Lb63:
bics r11, r12, #1
.Le63:
.balign 4
.hword (.Le64 - .Lb64) / 2, 0
.Lb64:
bics r0, r5, #0xff
.Le64:
.balign 4
.hword (.Le65 - .Lb65) / 2, 0
.Lb65:
bics r11, r5, #0x00ab00ab
.Le65:
.balign 4
.hword (.Le66 - .Lb66) / 2, 0
.Lb66:
bics r12, r9, #0xcd00cd00
.Le66:
.balign 4
.hword (.Le67 - .Lb67) / 2, 0
.Lb67:
bics r3, r12, #0x5e5e5e5e
.Le67:
.balign 4
.hword (.Le68 - .Lb68) / 2, 0
.Lb68:
bics lr, r9, #0x80000000
.Le68:
.balign 4
.hword (.Le69 - .Lb69) / 2, 0
.Lb69:
bics r0, r3, #0xff000000
.Le69:
.balign 4
.hword (.Le70 - .Lb70) / 2, 0
.Lb70:
bics r5, r5, #0x3fc00
.Le70:
.balign 4
.hword (.Le71 - .Lb71) / 2, 0
.Lb71:
bics r10, r11, #0x104
.Le71:
.balign 4
.hword (.Le72 - .Lb72) / 2, 0
.Lb72:
bics r11, r11, #0x7f8
.Le72:
.balign 4
.hword (.Le73 - .Lb73) / 2, 0
.Lb73:
bics r3, r10, #0x000001fe
.Le73:
.balign 4
.hword 0xffff, 0
.balign 4
group_bic_reg:
.balign 4
.hword (.Le74 - .Lb74) / 2, 0
.Lb74:
bic.w lr, r5, r3
.Le74:
.balign 4
.hword (.Le75 - .Lb75) / 2, 0
.Lb75:
bic.w r11, r0, r12, lsl #1
.Le75:
.balign 4
.hword (.Le76 - .Lb76) / 2, 0
.Lb76:
bic.w r3, r12, r5, lsl #7
.Le76:
.balign 4
.hword (.Le77 - .Lb77) / 2, 0
.Lb77:
bic.w r5, r11, r3, lsl #31
.Le77:
.balign 4
.hword (.Le78 - .Lb78) / 2, 0
.Lb78:
bic.w r12, r3, r9, lsr #1
.Le78:
.balign 4
.hword (.Le79 - .Lb79) / 2, 0
.Lb79:
bic.w r3, r10, r11, lsr #32
.Le79:
.balign 4
.hword (.Le80 - .Lb80) / 2, 0
.Lb80:
bic.w r10, r3, lr, lsr #13
.Le80:
.balign 4
.hword (.Le81 - .Lb81) / 2, 0
.Lb81:
bic.w r10, r3, r0, asr #1
.Le81:
.balign 4
.hword (.Le82 - .Lb82) / 2, 0
.Lb82:
bic.w r10, r0, r0, asr #32
.Le82:
.balign 4
.hword (.Le83 - .Lb83) / 2, 0
.Lb83:
bic.w r3, r12, r3, asr #20
.Le83:
.balign 4
.hword (.Le84 - .Lb84) / 2, 0
.Lb84:
bic.w r0, r9, r9, ror #1
.Le84:
.balign 4
.hword (.Le85 - .Lb85) / 2, 0
.Lb85:
bic.w r12, r5, r3, ror #31
.Le85:
.balign 4
.hword (.Le86 - .Lb86) / 2, 0
.Lb86:
bic.w lr, r5, r9, rrx
.Le86:
.balign 4
.hword (.Le87 - .Lb87) / 2, 0
.Lb87:
bics.w r5, r3, r12
.Le87:
.balign 4
.hword (.Le88 - .Lb88) / 2, 0
.Lb88:
bics.w r12, r10, r10, lsl #1
.Le88:
.balign 4
.hword (.Le89 - .Lb89) / 2, 0
.Lb89:
bics.w lr, r11, r3, lsl #7
.Le89:
.balign 4
.hword (.Le90 - .Lb90) / 2, 0
.Lb90:
bics.w r9, r11, r0, lsl #31
.Le90:
.balign 4
.hword (.Le91 - .Lb91) / 2, 0
.Lb91:
bics.w r0, r0, r10, lsr #1
.Le91:
.balign 4
.hword (.Le92 - .Lb92) / 2, 0
.Lb92:
bics.w r11, lr, r12, lsr #32
.Le92:
.balign 4
.hword (.Le93 - .Lb93) / 2, 0
.Lb93:
bics.w r11, r12, r3, lsr #13
.Le93:
.balign 4
.hword (.Le94 - .Lb94) / 2, 0
.Lb94:
bics.w r3, r11, lr, asr #1
.Le94:
.balign 4
.hword (.Le95 - .Lb95) / 2, 0
.Lb95:
bics.w r3, r10, r9, asr #32
.Le95:
.balign 4
.hword (.Le96 - .Lb96) / 2, 0
.Lb96:
bics.w lr, r11, r10, asr #20
.Le96:
.balign 4
.hword (.Le97 - .Lb97) / 2, 0
.Lb97:
bics.w r5, r9, r10, ror #1
.Le97:
.balign 4
.hword (.Le98 - .Lb98) / 2, 0
.Lb98:
bics.w r9, r9, r11, ror #31
.Le98:
.balign 4
.hword (.Le99 - .Lb99) / 2, 0
.Lb99:
bics.w r3, r10, r3, rrx
.Le99:
.balign 4
.hword 0xffff, 0
.balign 4
group_orr_imm:
.balign 4
.hword (.Le100 - .Lb100) / 2, 0
.Lb100:
orr lr, r3, #0
.Le100:
.balign 4
.hword (.Le101 - .Lb101) / 2, 0
.Lb101:
orr r9, r12, #1
.Le101:
.balign 4
.hword (.Le102 - .Lb102) / 2, 0
.Lb102:
orr r0, r11, #0xff
.Le102:
.balign 4
.hword (.Le103 - .Lb103) / 2, 0
.Lb103:
orr r11, r10, #0x00ab00ab
.Le103:
.balign 4
.hword (.Le104 - .Lb104) / 2, 0
.Lb104:
orr r11, r3, #0xcd00cd00
.Le104:
.balign 4
.hword (.Le105 - .Lb105) / 2, 0
.Lb105:
orr r9, r9, #0x5e5e5e5e
.Le105:
.balign 4
.hword (.Le106 - .Lb106) / 2, 0
.Lb106:
orr r9, r12, #0x80000000
.Le106:
.balign 4
.hword (.Le107 - .Lb107) / 2, 0
.Lb107:
orr r10, r3, #0xff000000
.Le107:
.balign 4
.hword (.Le108 - .Lb108) / 2, 0
.Lb108:
orr r0, r0, #0x3fc00
.Le108:
.balign 4
.hword (.Le109 - .Lb109) / 2, 0
.Lb109:
orr r11, lr, #0x104
.Le109:
.balign 4
.hword (.Le110 - .Lb110) / 2, 0
.Lb110:
orr r5, r3, #0x7f8
.Le110:
.balign 4
.hword (.Le111 - .Lb111) / 2, 0
.Lb111:
orr r3, r5, #0x000001fe
.Le111:
.balign 4
.hword (.Le112 - .Lb112) / 2, 0
.Lb112:
orrs r5, r5, #0
.Le112:
.balign 4
.hword (.Le113 - .Lb113) / 2, 0
.Lb113:
orrs r10, r3, #1
.Le113:
.balign 4
.hword (.Le114 - .Lb114) / 2, 0
.Lb114:
orrs r5, r9, #0xff
.Le114:
.balign 4
.hword (.Le115 - .Lb115) / 2, 0
.Lb115:
orrs r0, r11, #0x00ab00ab
.Le115:
.balign 4
.hword (.Le116 - .Lb116) / 2, 0
.Lb116:
orrs r5, r10, #0xcd00cd00
.Le116:
.balign 4
.hword (.Le117 - .Lb117) / 2, 0
.Lb117:
orrs r5, r0, #0x5e5e5e5e
.Le117:
.balign 4
.hword (.Le118 - .Lb118) / 2, 0
.Lb118:
orrs r10, r3, #0x80000000
.Le118:
.balign 4
.hword (.Le119 - .Lb119) / 2, 0
.Lb119:
orrs r12, r10, #0xff000000
.Le119:
.balign 4
.hword (.Le120 - .Lb120) / 2, 0
.Lb120:
orrs lr, r0, #0x3fc00
.Le120:
.balign 4
.hword (.Le121 - .Lb121) / 2, 0
.Lb121:
orrs r11, r5, #0x104
.Le121:
.balign 4
.hword (.Le122 - .Lb122) / 2, 0
.Lb122:
orrs lr, r0, #0x7f8
.Le122:
.balign 4
.hword (.Le123 - .Lb123) / 2, 0
.Lb123:
orrs r0, r0, #0x000001fe
.Le123:
.balign 4
.hword 0xffff, 0
.balign 4
group_orr_reg:
.balign 4
.hword (.Le124 - .Lb124) / 2, 0
.Lb124:
orr.w r5, r5, r5
.Le124:
.balign 4
.hword (.Le125 - .Lb125) / 2, 0
.Lb125:
orr.w r10, r10, r12, lsl #1
.Le125:
.balign 4
.hword (.Le126 - .Lb126) / 2, 0
.Lb126:
orr.w r12, r5, r3, lsl #7
.Le126:
.balign 4
.hword (.Le127 - .Lb127) / 2, 0
.Lb127:
orr.w r9, lr, r0, lsl #31
.Le127:
.balign 4
.hword (.Le128 - .Lb128) / 2, 0
.Lb128:
orr.w r5, r11, lr, lsr #1
.Le128:
.balign 4
.hword (.Le129 - .Lb129) / 2, 0
.Lb129:
orr.w r9, r9, r11, lsr #32
.Le129:
.balign 4
.hword (.Le130 - .Lb130) / 2, 0
.Lb130:
orr.w lr, lr, r9, lsr #13
.Le130:
.balign 4
.hword (.Le131 - .Lb131) / 2, 0
.Lb131:
orr.w r12, r11, r10, asr #1
.Le131:
.balign 4
.hword (.Le132 - .Lb132) / 2, 0
.Lb132:
orr.w r9, r0, r3, asr #32
.Le132:
.balign 4
.hword (.Le133 - .Lb133) / 2, 0
.Lb133:
orr.w r11, r5, r9, asr #20
.Le133:
.balign 4
.hword (.Le134 - .Lb134) / 2, 0
.Lb134:
orr.w r10, r10, r10, ror #1
.Le134:
.balign 4
.hword (.Le135 - .Lb135) / 2, 0
.Lb135:
orr.w r11, r5, lr, ror #31
.Le135:
.balign 4
.hword (.Le136 - .Lb136) / 2, 0
.Lb136:
orr.w r3, r3, r12, rrx
.Le136:
.balign 4
.hword (.Le137 - .Lb137) / 2, 0
.Lb137:
orrs.w r5, r5, r10
.Le137:
.balign 4
.hword (.Le138 - .Lb138) / 2, 0
.Lb138:
orrs.w r12, r9, r0, lsl #1
.Le138:
.balign 4
.hword (.Le139 - .Lb139) / 2, 0
.Lb139:
orrs.w lr, r12, r11, lsl #7
.Le139:
.balign 4
.hword (.Le140 - .Lb140) / 2, 0
.Lb140:
orrs.w r12, r5, r0, lsl #31
.Le140:
.balign 4
.hword (.Le141 - .Lb141) / 2, 0
.Lb141:
orrs.w r3, r10, r3, lsr #1
.Le141:
.balign 4
.hword (.Le142 - .Lb142) / 2, 0
.Lb142:
orrs.w r10, r3, r5, lsr #32
.Le142:
.balign 4
.hword (.Le143 - .Lb143) / 2, 0
.Lb143:
orrs.w r3, lr, r9, lsr #13
.Le143:
.balign 4
.hword (.Le144 - .Lb144) / 2, 0
.Lb144:
orrs.w r12, r12, r12, asr #1
.Le144:
.balign 4
.hword (.Le145 - .Lb145) / 2, 0
.Lb145:
orrs.w r5, r11, lr, asr #32
.Le145:
.balign 4
.hword (.Le146 - .Lb146) / 2, 0
.Lb146:
orrs.w r5, lr, r9, asr #20
.Le146:
.balign 4
.hword (.Le147 - .Lb147) / 2, 0
.Lb147:
orrs.w r3, r12, r12, ror #1
.Le147:
.balign 4
.hword (.Le148 - .Lb148) / 2, 0
.Lb148:
orrs.w r3, r10, r10, ror #31
.Le148:
.balign 4
.hword (.Le149 - .Lb149) / 2, 0
.Lb149:
orrs.w r9, r12, r0, rrx
.Le149:
.balign 4
.hword 0xffff, 0
.balign 4
group_orn_imm:
.balign 4
.hword (.Le150 - .Lb150) / 2, 0
.Lb150:
orn r9, lr, #0
.Le150:
.balign 4
.hword (.Le151 - .Lb151) / 2, 0
.Lb151:
orn r0, r9, #1
.Le151:
.balign 4
.hword (.Le152 - .Lb152) / 2, 0
.Lb152:
orn r9, r5, #0xff
.Le152:
.balign 4
.hword (.Le153 - .Lb153) / 2, 0
.Lb153:
orn r5, r9, #0x00ab00ab
.Le153:
.balign 4
.hword (.Le154 - .Lb154) / 2, 0
.Lb154:
orn r10, r10, #0xcd00cd00
.Le154:
.balign 4
.hword (.Le155 - .Lb155) / 2, 0
.Lb155:
orn r5, r11, #0x5e5e5e5e
.Le155:
.balign 4
.hword (.Le156 - .Lb156) / 2, 0
.Lb156:
orn r12, r3, #0x80000000
.Le156:
.balign 4
.hword (.Le157 - .Lb157) / 2, 0
.Lb157:
orn r12, r9, #0xff000000
.Le157:
.balign 4
.hword (.Le158 - .Lb158) / 2, 0
.Lb158:
orn r3, r0, #0x3fc00
.Le158:
.balign 4
.hword (.Le159 - .Lb159) / 2, 0
.Lb159:
orn r0, r10, #0x104
.Le159:
.balign 4
.hword (.Le160 - .Lb160) / 2, 0
.Lb160:
orn r3, r11, #0x7f8
.Le160:
.balign 4
.hword (.Le161 - .Lb161) / 2, 0
.Lb161:
orn r12, r11, #0x000001fe
.Le161:
.balign 4
.hword (.Le162 - .Lb162) / 2, 0
.Lb162:
orns r0, r3, #0
.Le162:
.balign 4
.hword (.Le163 - .Lb163) / 2, 0
.Lb163:
orns lr, r11, #1
.Le163:
.balign 4
.hword (.Le164 - .Lb164) / 2, 0
.Lb164:
orns r12, r11, #0xff
.Le164:
.balign 4
.hword (.Le165 - .Lb165) / 2, 0
.Lb165:
orns r3, r12, #0x00ab00ab
.Le165:
.balign 4
.hword (.Le166 - .Lb166) / 2, 0
.Lb166:
orns r9, r0, #0xcd00cd00
.Le166:
.balign 4
.hword (.Le167 - .Lb167) / 2, 0
.Lb167:
orns r9, lr, #0x5e5e5e5e
.Le167:
.balign 4
.hword (.Le168 - .Lb168) / 2, 0
.Lb168:
orns r10, r5, #0x80000000
.Le168:
.balign 4
.hword (.Le169 - .Lb169) / 2, 0
.Lb169:
orns r9, r11, #0xff000000
.Le169:
.balign 4
.hword (.Le170 - .Lb170) / 2, 0
.Lb170:
orns r12, r12, #0x3fc00
.Le170:
.balign 4
.hword (.Le171 - .Lb171) / 2, 0
.Lb171:
orns r11, r3, #0x104
.Le171:
.balign 4
.hword (.Le172 - .Lb172) / 2, 0
.Lb172:
orns r9, r10, #0x7f8
.Le172:
.balign 4
.hword (.Le173 - .Lb173) / 2, 0
.Lb173:
orns r12, r5, #0x000001fe
.Le173:
.balign 4
.hword 0xffff, 0
.balign 4
group_orn_reg:
.balign 4
.hword (.Le174 - .Lb174) / 2, 0
.Lb174:
orn.w r10, r5, r3
.Le174:
.balign 4
.hword (.Le175 - .Lb175) / 2, 0
.Lb175:
orn.w r0, r11, r10, lsl #1
.Le175:
.balign 4
.hword (.Le176 - .Lb176) / 2, 0
.Lb176:
orn.w r12, r10, r5, lsl #7
.Le176:
.balign 4
.hword (.Le177 - .Lb177) / 2, 0
.Lb177:
orn.w lr, r10, lr, lsl #31
.Le177:
.balign 4
.hword (.Le178 - .Lb178) / 2, 0
.Lb178:
orn.w r5, lr, r0, lsr #1
.Le178:
.balign 4
.hword (.Le179 - .Lb179) / 2, 0
.Lb179:
orn.w r10, r3, r12, lsr #32
.Le179:
.balign 4
.hword (.Le180 - .Lb180) / 2, 0
.Lb180:
orn.w r3, r11, r3, lsr #13
.Le180:
.balign 4
.hword (.Le181 - .Lb181) / 2, 0
.Lb181:
orn.w lr, r0, r5, asr #1
.Le181:
.balign 4
.hword (.Le182 - .Lb182) / 2, 0
.Lb182:
orn.w r5, r3, r12, asr #32
.Le182:
.balign 4
.hword (.Le183 - .Lb183) / 2, 0
.Lb183:
orn.w r10, r10, r9, asr #20
.Le183:
.balign 4
.hword (.Le184 - .Lb184) / 2, 0
.Lb184:
orn.w r9, r9, r11, ror #1
.Le184:
.balign 4
.hword (.Le185 - .Lb185) / 2, 0
.Lb185:
orn.w r10, r3, r3, ror #31
.Le185:
.balign 4
.hword (.Le186 - .Lb186) / 2, 0
.Lb186:
orn.w r11, lr, r0, rrx
.Le186:
.balign 4
.hword (.Le187 - .Lb187) / 2, 0
.Lb187:
orns.w r5, r10, r10
.Le187:
.balign 4
.hword (.Le188 - .Lb188) / 2, 0
.Lb188:
orns.w r11, r9, r12, lsl #1
.Le188:
.balign 4
.hword (.Le189 - .Lb189) / 2, 0
.Lb189:
orns.w r12, r5, lr, lsl #7
.Le189:
.balign 4
.hword (.Le190 - .Lb190) / 2, 0
.Lb190:
orns.w r10, r11, r9, lsl #31
.Le190:
.balign 4
.hword (.Le191 - .Lb191) / 2, 0
.Lb191:
orns.w r10, r9, r0, lsr #1
.Le191:
.balign 4
.hword (.Le192 - .Lb192) / 2, 0
.Lb192:
orns.w r12, r11, r12, lsr #32
.Le192:
.balign 4
.hword (.Le193 - .Lb193) / 2, 0
.Lb193:
orns.w r9, r10, r9, lsr #13
.Le193:
.balign 4
.hword (.Le194 - .Lb194) / 2, 0
.Lb194:
orns.w r3, r5, lr, asr #1
.Le194:
.balign 4
.hword (.Le195 - .Lb195) / 2, 0
.Lb195:
orns.w r5, r10, lr, asr #32
.Le195:
.balign 4
.hword (.Le196 - .Lb196) / 2, 0
.Lb196:
orns.w r5, r5, r5, asr #20
.Le196:
.balign 4
.hword (.Le197 - .Lb197) / 2, 0
.Lb197:
orns.w lr, r11, r10, ror #1
.Le197:
.balign 4
.hword (.Le198 - .Lb198) / 2, 0
.Lb198:
orns.w r12, r9, r3, ror #31
.Le198:
.balign 4
.hword (.Le199 - .Lb199) / 2, 0
.Lb199:
orns.w r9, r10, r3, rrx
.Le199:
.balign 4
.hword 0xffff, 0
.balign 4
group_eor_imm:
.balign 4
.hword (.Le200 - .Lb200) / 2, 0
.Lb200:
eor r3, r9, #0
.Le200:
.balign 4
.hword (.Le201 - .Lb201) / 2, 0
.Lb201:
eor r11, lr, #1
.Le201:
.balign 4
.hword (.Le202 - .Lb202) / 2, 0
.Lb202:
eor r5, r0, #0xff
.Le202:
.balign 4
.hword (.Le203 - .Lb203) / 2, 0
.Lb203:
eor r0, r9, #0x00ab00ab
.Le203:
.balign 4
.hword (.Le204 - .Lb204) / 2, 0
.Lb204:
eor lr, lr, #0xcd00cd00
.Le204:
.balign 4
.hword (.Le205 - .Lb205) / 2, 0
.Lb205:
eor r10, r3, #0x5e5e5e5e
.Le205:
.balign 4
.hword (.Le206 - .Lb206) / 2, 0
.Lb206:
eor r3, r9, #0x80000000
.Le206:
.balign 4
.hword (.Le207 - .Lb207) / 2, 0
.Lb207:
eor r9, lr, #0xff000000
.Le207:
.balign 4
.hword (.Le208 - .Lb208) / 2, 0
.Lb208:
eor r12, r5, #0x3fc00
.Le208:
.balign 4
.hword (.Le209 - .Lb209) / 2, 0
.Lb209:
eor r9, r10, #0x104
.Le209:
.balign 4
.hword (.Le210 - .Lb210) / 2, 0
.Lb210:
eor r12, r9, #0x7f8
.Le210:
.balign 4
.hword (.Le211 - .Lb211) / 2, 0
.Lb211:
eor r10, r11, #0x000001fe
.Le211:
.balign 4
.hword (.Le212 - .Lb212) / 2, 0
.Lb212:
eors r3, r9, #0
.Le212:
.balign 4
.hword (.Le213 - .Lb213) / 2, 0
.Lb213:
eors r0, r0, #1
.Le213:
.balign 4
.hword (.Le214 - .Lb214) / 2, 0
.Lb214:
eors lr, r11, #0xff
.Le214:
.balign 4
.hword (.Le215 - .Lb215) / 2, 0
.Lb215:
eors r10, r9, #0x00ab00ab
.Le215:
.balign 4
.hword (.Le216 - .Lb216) / 2, 0
.Lb216:
eors r5, r5, #0xcd00cd00
.Le216:
.balign 4
.hword (.Le217 - .Lb217) / 2, 0
.Lb217:
eors r0, r12, #0x5e5e5e5e
.Le217:
.balign 4
.hword (.Le218 - .Lb218) / 2, 0
.Lb218:
eors r0, r12, #0x80000000
.Le218:
.balign 4
.hword (.Le219 - .Lb219) / 2, 0
.Lb219:
eors r5, r3, #0xff000000
.Le219:
.balign 4
.hword (.Le220 - .Lb220) / 2, 0
.Lb220:
eors r10, r0, #0x3fc00
.Le220:
.balign 4
.hword (.Le221 - .Lb221) / 2, 0
.Lb221:
eors r0, r5, #0x104
.Le221:
.balign 4
.hword (.Le222 - .Lb222) / 2, 0
.Lb222:
eors r10, r3, #0x7f8
.Le222:
.balign 4
.hword (.Le223 - .Lb223) / 2, 0
.Lb223:
eors r3, r9, #0x000001fe
.Le223:
.balign 4
.hword 0xffff, 0
.balign 4
group_eor_reg:
.balign 4
.hword (.Le224 - .Lb224) / 2, 0
.Lb224:
eor.w lr, r5, r10
.Le224:
.balign 4
.hword (.Le225 - .Lb225) / 2, 0
.Lb225:
eor.w r9, lr, r12, lsl #1
.Le225:
.balign 4
.hword (.Le226 - .Lb226) / 2, 0
.Lb226:
eor.w r11, r10, r10, lsl #7
.Le226:
.balign 4
.hword (.Le227 - .Lb227) / 2, 0
.Lb227:
eor.w r9, r9, r0, lsl #31
.Le227:
.balign 4
.hword (.Le228 - .Lb228) / 2, 0
.Lb228:
eor.w r5, r11, r12, lsr #1
.Le228:
.balign 4
.hword (.Le229 - .Lb229) / 2, 0
.Lb229:
eor.w r0, r11, r12, lsr #32
.Le229:
.balign 4
.hword (.Le230 - .Lb230) / 2, 0
.Lb230:
eor.w r9, r12, r3, lsr #13
.Le230:
.balign 4
.hword (.Le231 - .Lb231) / 2, 0
.Lb231:
eor.w r10, r3, r10, asr #1
.Le231:
.balign 4
.hword (.Le232 - .Lb232) / 2, 0
.Lb232:
eor.w r5, r3, r5, asr #32
.Le232:
.balign 4
.hword (.Le233 - .Lb233) / 2, 0
.Lb233:
eor.w r0, r9, r12, asr #20
.Le233:
.balign 4
.hword (.Le234 - .Lb234) / 2, 0
.Lb234:
eor.w r0, r0, r3, ror #1
.Le234:
.balign 4
.hword (.Le235 - .Lb235) / 2, 0
.Lb235:
eor.w lr, r11, r3, ror #31
.Le235:
.balign 4
.hword (.Le236 - .Lb236) / 2, 0
.Lb236:
eor.w r11, r0, r5, rrx
.Le236:
.balign 4
.hword (.Le237 - .Lb237) / 2, 0
.Lb237:
eors.w r0, lr, r5
.Le237:
.balign 4
.hword (.Le238 - .Lb238) / 2, 0
.Lb238:
eors.w r12, lr, r0, lsl #1
.Le238:
.balign 4
.hword (.Le239 - .Lb239) / 2, 0
.Lb239:
eors.w r10, r3, r10, lsl #7
.Le239:
.balign 4
.hword (.Le240 - .Lb240) / 2, 0
.Lb240:
eors.w r11, r3, r10, lsl #31
.Le240:
.balign 4
.hword (.Le241 - .Lb241) / 2, 0
.Lb241:
eors.w r0, r12, r0, lsr #1
.Le241:
.balign 4
.hword (.Le242 - .Lb242) / 2, 0
.Lb242:
eors.w r10, r11, r5, lsr #32
.Le242:
.balign 4
.hword (.Le243 - .Lb243) / 2, 0
.Lb243:
eors.w r10, r12, r3, lsr #13
.Le243:
.balign 4
.hword (.Le244 - .Lb244) / 2, 0
.Lb244:
eors.w r10, r3, r12, asr #1
.Le244:
.balign 4
.hword (.Le245 - .Lb245) / 2, 0
.Lb245:
eors.w r9, r9, r11, asr #32
.Le245:
.balign 4
.hword (.Le246 - .Lb246) / 2, 0
.Lb246:
eors.w r11, r12, lr, asr #20
.Le246:
.balign 4
.hword (.Le247 - .Lb247) / 2, 0
.Lb247:
eors.w r3, r5, lr, ror #1
.Le247:
.balign 4
.hword (.Le248 - .Lb248) / 2, 0
.Lb248:
eors.w r0, r10, r5, ror #31
.Le248:
.balign 4
.hword (.Le249 - .Lb249) / 2, 0
.Lb249:
eors.w r9, r11, r12, rrx
.Le249:
.balign 4
.hword 0xffff, 0
.balign 4
group_add_imm:
.balign 4
.hword (.Le250 - .Lb250) / 2, 0
.Lb250:
add.w r11, r3, #0
.Le250:
.balign 4
.hword (.Le251 - .Lb251) / 2, 0
.Lb251:
add.w r11, r5, #1
.Le251:
.balign 4
.hword (.Le252 - .Lb252) / 2, 0
.Lb252:
add.w r0, r10, #0xff
.Le252:
.balign 4
.hword (.Le253 - .Lb253) / 2, 0
.Lb253:
add.w r12, r10, #0x00ab00ab
.Le253:
.balign 4
.hword (.Le254 - .Lb254) / 2, 0
.Lb254:
add.w r11, r10, #0xcd00cd00
.Le254:
.balign 4
.hword (.Le255 - .Lb255) / 2, 0
.Lb255:
add.w r0, r3, #0x5e5e5e5e
.Le255:
.balign 4
.hword (.Le256 - .Lb256) / 2, 0
.Lb256:
add.w r11, r11, #0x80000000
.Le256:
.balign 4
.hword (.Le257 - .Lb257) / 2, 0
.Lb257:
add.w r3, lr, #0xff000000
.Le257:
.balign 4
.hword (.Le258 - .Lb258) / 2, 0
.Lb258:
add.w lr, lr, #0x3fc00
.Le258:
.balign 4
.hword (.Le259 - .Lb259) / 2, 0
.Lb259:
add.w r12, r3, #0x104
.Le259:
.balign 4
.hword (.Le260 - .Lb260) / 2, 0
.Lb260:
add.w r5, r0, #0x7f8
.Le260:
.balign 4
.hword (.Le261 - .Lb261) / 2, 0
.Lb261:
add.w r10, r9, #0x000001fe
.Le261:
.balign 4
.hword (.Le262 - .Lb262) / 2, 0
.Lb262:
adds.w r11, r11, #0
.Le262:
.balign 4
.hword (.Le263 - .Lb263) / 2, 0
.Lb263:
adds.w r10, lr, #1
.Le263:
.balign 4
.hword (.Le264 - .Lb264) / 2, 0
.Lb264:
adds.w r5, r0, #0xff
.Le264:
.balign 4
.hword (.Le265 - .Lb265) / 2, 0
.Lb265:
adds.w r10, r9, #0x00ab00ab
.Le265:
.balign 4
.hword (.Le266 - .Lb266) / 2, 0
.Lb266:
adds.w r3, r5, #0xcd00cd00
.Le266:
.balign 4
.hword (.Le267 - .Lb267) / 2, 0
.Lb267:
adds.w r0, r3, #0x5e5e5e5e
.Le267:
.balign 4
.hword (.Le268 - .Lb268) / 2, 0
.Lb268:
adds.w r3, r9, #0x80000000
.Le268:
.balign 4
.hword (.Le269 - .Lb269) / 2, 0
.Lb269:
adds.w r3, r3, #0xff000000
.Le269:
.balign 4
.hword (.Le270 - .Lb270) / 2, 0
.Lb270:
adds.w r9, r5, #0x3fc00
.Le270:
.balign 4
.hword (.Le271 - .Lb271) / 2, 0
.Lb271:
adds.w r0, r11, #0x104
.Le271:
.balign 4
.hword (.Le272 - .Lb272) / 2, 0
.Lb272:
adds.w r10, r9, #0x7f8
.Le272:
.balign 4
.hword (.Le273 - .Lb273) / 2, 0
.Lb273:
adds.w lr, r9, #0x000001fe
.Le273:
.balign 4
.hword 0xffff, 0
.balign 4
group_add_reg:
.balign 4
.hword (.Le274 - .Lb274) / 2, 0
.Lb274:
add.w lr, r11, r9
.Le274:
.balign 4
.hword (.Le275 - .Lb275) / 2, 0
.Lb275:
add.w lr, r3, r10, lsl #1
.Le275:
.balign 4
.hword (.Le276 - .Lb276) / 2, 0
.Lb276:
add.w r12, r9, r0, lsl #7
.Le276:
.balign 4
.hword (.Le277 - .Lb277) / 2, 0
.Lb277:
add.w r12, lr, r3, lsl #31
.Le277:
.balign 4
.hword (.Le278 - .Lb278) / 2, 0
.Lb278:
add.w r12, r12, r0, lsr #1
.Le278:
.balign 4
.hword (.Le279 - .Lb279) / 2, 0
.Lb279:
add.w r11, lr, r0, lsr #32
.Le279:
.balign 4
.hword (.Le280 - .Lb280) / 2, 0
.Lb280:
add.w r9, r10, r0, lsr #13
.Le280:
.balign 4
.hword (.Le281 - .Lb281) / 2, 0
.Lb281:
add.w r3, r10, r11, asr #1
.Le281:
.balign 4
.hword (.Le282 - .Lb282) / 2, 0
.Lb282:
add.w r10, r12, r12, asr #32
.Le282:
.balign 4
.hword (.Le283 - .Lb283) / 2, 0
.Lb283:
add.w r10, lr, r10, asr #20
.Le283:
.balign 4
.hword (.Le284 - .Lb284) / 2, 0
.Lb284:
add.w r5, lr, r5, ror #1
.Le284:
.balign 4
.hword (.Le285 - .Lb285) / 2, 0
.Lb285:
add.w r5, r10, r0, ror #31
.Le285:
.balign 4
.hword (.Le286 - .Lb286) / 2, 0
.Lb286:
add.w r12, r0, r11, rrx
.Le286:
.balign 4
.hword (.Le287 - .Lb287) / 2, 0
.Lb287:
adds.w r12, r12, r10
.Le287:
.balign 4
.hword (.Le288 - .Lb288) / 2, 0
.Lb288:
adds.w r0, r3, r3, lsl #1
.Le288:
.balign 4
.hword (.Le289 - .Lb289) / 2, 0
.Lb289:
adds.w r0, r12, r10, lsl #7
.Le289:
.balign 4
.hword (.Le290 - .Lb290) / 2, 0
.Lb290:
adds.w lr, r10, r11, lsl #31
.Le290:
.balign 4
.hword (.Le291 - .Lb291) / 2, 0
.Lb291:
adds.w lr, r11, r12, lsr #1
.Le291:
.balign 4
.hword (.Le292 - .Lb292) / 2, 0
.Lb292:
adds.w lr, r3, lr, lsr #32
.Le292:
.balign 4
.hword (.Le293 - .Lb293) / 2, 0
.Lb293:
adds.w r11, r5, r12, lsr #13
.Le293:
.balign 4
.hword (.Le294 - .Lb294) / 2, 0
.Lb294:
adds.w r5, r0, r5, asr #1
.Le294:
.balign 4
.hword (.Le295 - .Lb295) / 2, 0
.Lb295:
adds.w r10, r11, r5, asr #32
.Le295:
.balign 4
.hword (.Le296 - .Lb296) / 2, 0
.Lb296:
adds.w r10, r12, r10, asr #20
.Le296:
.balign 4
.hword (.Le297 - .Lb297) / 2, 0
.Lb297:
adds.w r10, r12, r10, ror #1
.Le297:
.balign 4
.hword (.Le298 - .Lb298) / 2, 0
.Lb298:
adds.w r12, r11, lr, ror #31
.Le298:
.balign 4
.hword (.Le299 - .Lb299) / 2, 0
.Lb299:
adds.w r9, lr, r12, rrx
.Le299:
.balign 4
.hword 0xffff, 0
.balign 4
group_adc_imm:
.balign 4
.hword (.Le300 - .Lb300) / 2, 0
.Lb300:
adc r12, r3, #0
.Le300:
.balign 4
.hword (.Le301 - .Lb301) / 2, 0
.Lb301:
adc r5, r9, #1
.Le301:
.balign 4
.hword (.Le302 - .Lb302) / 2, 0
.Lb302:
adc r9, r0, #0xff
.Le302:
.balign 4
.hword (.Le303 - .Lb303) / 2, 0
.Lb303:
adc r10, r5, #0x00ab00ab
.Le303:
.balign 4
.hword (.Le304 - .Lb304) / 2, 0
.Lb304:
adc r3, r12, #0xcd00cd00
.Le304:
.balign 4
.hword (.Le305 - .Lb305) / 2, 0
.Lb305:
adc r0, r3, #0x5e5e5e5e
.Le305:
.balign 4
.hword (.Le306 - .Lb306) / 2, 0
.Lb306:
adc r0, r9, #0x80000000
.Le306:
.balign 4
.hword (.Le307 - .Lb307) / 2, 0
.Lb307:
adc r11, r0, #0xff000000
.Le307:
.balign 4
.hword (.Le308 - .Lb308) / 2, 0
.Lb308:
adc r12, r3, #0x3fc00
.Le308:
.balign 4
.hword (.Le309 - .Lb309) / 2, 0
.Lb309:
adc r10, r5, #0x104
.Le309:
.balign 4
.hword (.Le310 - .Lb310) / 2, 0
.Lb310:
adc r0, r9, #0x7f8
.Le310:
.balign 4
.hword (.Le311 - .Lb311) / 2, 0
.Lb311:
adc r12, r3, #0x000001fe
.Le311:
.balign 4
.hword (.Le312 - .Lb312) / 2, 0
.Lb312:
adcs r10, lr, #0
.Le312:
.balign 4
.hword (.Le313 - .Lb313) / 2, 0
.Lb313:
adcs r3, lr, #1
.Le313:
.balign 4
.hword (.Le314 - .Lb314) / 2, 0
.Lb314:
adcs r5, r12, #0xff
.Le314:
.balign 4
.hword (.Le315 - .Lb315) / 2, 0
.Lb315:
adcs r5, r10, #0x00ab00ab
.Le315:
.balign 4
.hword (.Le316 - .Lb316) / 2, 0
.Lb316:
adcs r10, lr, #0xcd00cd00
.Le316:
.balign 4
.hword (.Le317 - .Lb317) / 2, 0
.Lb317:
adcs r11, lr, #0x5e5e5e5e
.Le317:
.balign 4
.hword (.Le318 - .Lb318) / 2, 0
.Lb318:
adcs r0, r11, #0x80000000
.Le318:
.balign 4
.hword (.Le319 - .Lb319) / 2, 0
.Lb319:
adcs r0, lr, #0xff000000
.Le319:
.balign 4
.hword (.Le320 - .Lb320) / 2, 0
.Lb320:
adcs r3, r9, #0x3fc00
.Le320:
.balign 4
.hword (.Le321 - .Lb321) / 2, 0
.Lb321:
adcs r10, r9, #0x104
.Le321:
.balign 4
.hword (.Le322 - .Lb322) / 2, 0
.Lb322:
adcs r5, r5, #0x7f8
.Le322:
.balign 4
.hword (.Le323 - .Lb323) / 2, 0
.Lb323:
adcs r9, r12, #0x000001fe
.Le323:
.balign 4
.hword 0xffff, 0
.balign 4
group_adc_reg:
.balign 4
.hword (.Le324 - .Lb324) / 2, 0
.Lb324:
adc.w r5, r12, r10
.Le324:
.balign 4
.hword (.Le325 - .Lb325) / 2, 0
.Lb325:
adc.w r10, lr, r10, lsl #1
.Le325:
.balign 4
.hword (.Le326 - .Lb326) / 2, 0
.Lb326:
adc.w r10, lr, r9, lsl #7
.Le326:
.balign 4
.hword (.Le327 - .Lb327) / 2, 0
.Lb327:
adc.w lr, r11, lr, lsl #31
.Le327:
.balign 4
.hword (.Le328 - .Lb328) / 2, 0
.Lb328:
adc.w r9, r11, r5, lsr #1
.Le328:
.balign 4
.hword (.Le329 - .Lb329) / 2, 0
.Lb329:
adc.w r5, lr, r5, lsr #32
.Le329:
.balign 4
.hword (.Le330 - .Lb330) / 2, 0
.Lb330:
adc.w r0, r11, r5, lsr #13
.Le330:
.balign 4
.hword (.Le331 - .Lb331) / 2, 0
.Lb331:
adc.w r9, r11, lr, asr #1
.Le331:
.balign 4
.hword (.Le332 - .Lb332) / 2, 0
.Lb332:
adc.w lr, r11, r3, asr #32
.Le332:
.balign 4
.hword (.Le333 - .Lb333) / 2, 0
.Lb333:
adc.w r5, r5, r10, asr #20
.Le333:
.balign 4
.hword (.Le334 - .Lb334) / 2, 0
.Lb334:
adc.w r9, r3, r0, ror #1
.Le334:
.balign 4
.hword (.Le335 - .Lb335) / 2, 0
.Lb335:
adc.w r5, r3, r9, ror #31
.Le335:
.balign 4
.hword (.Le336 - .Lb336) / 2, 0
.Lb336:
adc.w r9, r10, r12, rrx
.Le336:
.balign 4
.hword (.Le337 - .Lb337) / 2, 0
.Lb337:
adcs.w r11, r0, r0
.Le337:
.balign 4
.hword (.Le338 - .Lb338) / 2, 0
.Lb338:
adcs.w r10, r9, r3, lsl #1
.Le338:
.balign 4
.hword (.Le339 - .Lb339) / 2, 0
.Lb339:
adcs.w r9, r10, r11, lsl #7
.Le339:
.balign 4
.hword (.Le340 - .Lb340) / 2, 0
.Lb340:
adcs.w r10, r12, r0, lsl #31
.Le340:
.balign 4
.hword (.Le341 - .Lb341) / 2, 0
.Lb341:
adcs.w r3, r11, r11, lsr #1
.Le341:
.balign 4
.hword (.Le342 - .Lb342) / 2, 0
.Lb342:
adcs.w r5, r3, r10, lsr #32
.Le342:
.balign 4
.hword (.Le343 - .Lb343) / 2, 0
.Lb343:
adcs.w r5, r0, r11, lsr #13
.Le343:
.balign 4
.hword (.Le344 - .Lb344) / 2, 0
.Lb344:
adcs.w r3, r3, r3, asr #1
.Le344:
.balign 4
.hword (.Le345 - .Lb345) / 2, 0
.Lb345:
adcs.w r10, r11, r9, asr #32
.Le345:
.balign 4
.hword (.Le346 - .Lb346) / 2, 0
.Lb346:
adcs.w r10, r0, r11, asr #20
.Le346:
.balign 4
.hword (.Le347 - .Lb347) / 2, 0
.Lb347:
adcs.w r0, r3, r5, ror #1
.Le347:
.balign 4
.hword (.Le348 - .Lb348) / 2, 0
.Lb348:
adcs.w r12, r11, r9, ror #31
.Le348:
.balign 4
.hword (.Le349 - .Lb349) / 2, 0
.Lb349:
adcs.w r3, r11, r10, rrx
.Le349:
.balign 4
.hword 0xffff, 0
.balign 4
group_sbc_imm:
.balign 4
.hword (.Le350 - .Lb350) / 2, 0
.Lb350:
sbc r0, r11, #0
.Le350:
.balign 4
.hword (.Le351 - .Lb351) / 2, 0
.Lb351:
sbc r11, r5, #1
.Le351:
.balign 4
.hword (.Le352 - .Lb352) / 2, 0
.Lb352:
sbc r12, r3, #0xff
.Le352:
.balign 4
.hword (.Le353 - .Lb353) / 2, 0
.Lb353:
sbc r12, r12, #0x00ab00ab
.Le353:
.balign 4
.hword (.Le354 - .Lb354) / 2, 0
.Lb354:
sbc r9, r10, #0xcd00cd00
.Le354:
.balign 4
.hword (.Le355 - .Lb355) / 2, 0
.Lb355:
sbc r0, r3, #0x5e5e5e5e
.Le355:
.balign 4
.hword (.Le356 - .Lb356) / 2, 0
.Lb356:
sbc r9, r9, #0x80000000
.Le356:
.balign 4
.hword (.Le357 - .Lb357) / 2, 0
.Lb357:
sbc r10, r0, #0xff000000
.Le357:
.balign 4
.hword (.Le358 - .Lb358) / 2, 0
.Lb358:
sbc r10, r10, #0x3fc00
.Le358:
.balign 4
.hword (.Le359 - .Lb359) / 2, 0
.Lb359:
sbc r5, r12, #0x104
.Le359:
.balign 4
.hword (.Le360 - .Lb360) / 2, 0
.Lb360:
sbc r11, r3, #0x7f8
.Le360:
.balign 4
.hword (.Le361 - .Lb361) / 2, 0
.Lb361:
sbc r0, r10, #0x000001fe
.Le361:
.balign 4
.hword (.Le362 - .Lb362) / 2, 0
.Lb362:
sbcs r5, r5, #0
.Le362:
.balign 4
.hword (.Le363 - .Lb363) / 2, 0
.Lb363:
sbcs r5, r9, #1
.Le363:
.balign 4
.hword (.Le364 - .Lb364) / 2, 0
.Lb364:
sbcs r11, r11, #0xff
.Le364:
.balign 4
.hword (.Le365 - .Lb365) / 2, 0
.Lb365:
sbcs r5, r5, #0x00ab00ab
.Le365:
.balign 4
.hword (.Le366 - .Lb366) / 2, 0
.Lb366:
sbcs lr, r12, #0xcd00cd00
.Le366:
.balign 4
.hword (.Le367 - .Lb367) / 2, 0
.Lb367:
sbcs r5, r10, #0x5e5e5e5e
.Le367:
.balign 4
.hword (.Le368 - .Lb368) / 2, 0
.Lb368:
sbcs r0, r0, #0x80000000
.Le368:
.balign 4
.hword (.Le369 - .Lb369) / 2, 0
.Lb369:
sbcs r12, r3, #0xff000000
.Le369:
.balign 4
.hword (.Le370 - .Lb370) / 2, 0
.Lb370:
sbcs r0, r12, #0x3fc00
.Le370:
.balign 4
.hword (.Le371 - .Lb371) / 2, 0
.Lb371:
sbcs r10, r11, #0x104
.Le371:
.balign 4
.hword (.Le372 - .Lb372) / 2, 0
.Lb372:
sbcs r12, lr, #0x7f8
.Le372:
.balign 4
.hword (.Le373 - .Lb373) / 2, 0
.Lb373:
sbcs r3, lr, #0x000001fe
.Le373:
.balign 4
.hword 0xffff, 0
.balign 4
group_sbc_reg:
.balign 4
.hword (.Le374 - .Lb374) / 2, 0
.Lb374:
sbc.w r0, r0, r3
.Le374:
.balign 4
.hword (.Le375 - .Lb375) / 2, 0
.Lb375:
sbc.w r5, r11, r10, lsl #1
.Le375:
.balign 4
.hword (.Le376 - .Lb376) / 2, 0
.Lb376:
sbc.w r11, lr, r9, lsl #7
.Le376:
.balign 4
.hword (.Le377 - .Lb377) / 2, 0
.Lb377:
sbc.w r9, r3, r11, lsl #31
.Le377:
.balign 4
.hword (.Le378 - .Lb378) / 2, 0
.Lb378:
sbc.w r5, r3, r0, lsr #1
.Le378:
.balign 4
.hword (.Le379 - .Lb379) / 2, 0
.Lb379:
sbc.w r11, r12, r11, lsr #32
.Le379:
.balign 4
.hword (.Le380 - .Lb380) / 2, 0
.Lb380:
sbc.w r10, r0, r12, lsr #13
.Le380:
.balign 4
.hword (.Le381 - .Lb381) / 2, 0
.Lb381:
sbc.w r12, r12, r11, asr #1
.Le381:
.balign 4
.hword (.Le382 - .Lb382) / 2, 0
.Lb382:
sbc.w r10, r11, lr, asr #32
.Le382:
.balign 4
.hword (.Le383 - .Lb383) / 2, 0
.Lb383:
sbc.w r9, r5, r0, asr #20
.Le383:
.balign 4
.hword (.Le384 - .Lb384) / 2, 0
.Lb384:
sbc.w r11, r3, r5, ror #1
.Le384:
.balign 4
.hword (.Le385 - .Lb385) / 2, 0
.Lb385:
sbc.w lr, r11, r3, ror #31
.Le385:
.balign 4
.hword (.Le386 - .Lb386) / 2, 0
.Lb386:
sbc.w r0, lr, r9, rrx
.Le386:
.balign 4
.hword (.Le387 - .Lb387) / 2, 0
.Lb387:
sbcs.w r12, r5, r12
.Le387:
.balign 4
.hword (.Le388 - .Lb388) / 2, 0
.Lb388:
sbcs.w r9, r3, r9, lsl #1
.Le388:
.balign 4
.hword (.Le389 - .Lb389) / 2, 0
.Lb389:
sbcs.w r11, r11, r9, lsl #7
.Le389:
.balign 4
.hword (.Le390 - .Lb390) / 2, 0
.Lb390:
sbcs.w lr, lr, r11, lsl #31
.Le390:
.balign 4
.hword (.Le391 - .Lb391) / 2, 0
.Lb391:
sbcs.w lr, r9, r12, lsr #1
.Le391:
.balign 4
.hword (.Le392 - .Lb392) / 2, 0
.Lb392:
sbcs.w lr, r12, r3, lsr #32
.Le392:
.balign 4
.hword (.Le393 - .Lb393) / 2, 0
.Lb393:
sbcs.w lr, r10, r5, lsr #13
.Le393:
.balign 4
.hword (.Le394 - .Lb394) / 2, 0
.Lb394:
sbcs.w r5, r0, r12, asr #1
.Le394:
.balign 4
.hword (.Le395 - .Lb395) / 2, 0
.Lb395:
sbcs.w r12, r3, r0, asr #32
.Le395:
.balign 4
.hword (.Le396 - .Lb396) / 2, 0
.Lb396:
sbcs.w r3, r5, lr, asr #20
.Le396:
.balign 4
.hword (.Le397 - .Lb397) / 2, 0
.Lb397:
sbcs.w r12, r10, r5, ror #1
.Le397:
.balign 4
.hword (.Le398 - .Lb398) / 2, 0
.Lb398:
sbcs.w r5, r3, r10, ror #31
.Le398:
.balign 4
.hword (.Le399 - .Lb399) / 2, 0
.Lb399:
sbcs.w r0, lr, r12, rrx
.Le399:
.balign 4
.hword 0xffff, 0
.balign 4
group_sub_imm:
.balign 4
.hword (.Le400 - .Lb400) / 2, 0
.Lb400:
sub.w r9, r12, #0
.Le400:
.balign 4
.hword (.Le401 - .Lb401) / 2, 0
.Lb401:
sub.w r9, r12, #1
.Le401:
.balign 4
.hword (.Le402 - .Lb402) / 2, 0
.Lb402:
sub.w r5, r11, #0xff
.Le402:
.balign 4
.hword (.Le403 - .Lb403) / 2, 0
.Lb403:
sub.w r3, r5, #0x00ab00ab
.Le403:
.balign 4
.hword (.Le404 - .Lb404) / 2, 0
.Lb404:
sub.w r12, r0, #0xcd00cd00
.Le404:
.balign 4
.hword (.Le405 - .Lb405) / 2, 0
.Lb405:
sub.w r12, r9, #0x5e5e5e5e
.Le405:
.balign 4
.hword (.Le406 - .Lb406) / 2, 0
.Lb406:
sub.w r9, r3, #0x80000000
.Le406:
.balign 4
.hword (.Le407 - .Lb407) / 2, 0
.Lb407:
sub.w r12, lr, #0xff000000
.Le407:
.balign 4
.hword (.Le408 - .Lb408) / 2, 0
.Lb408:
sub.w r0, r12, #0x3fc00
.Le408:
.balign 4
.hword (.Le409 - .Lb409) / 2, 0
.Lb409:
sub.w r3, lr, #0x104
.Le409:
.balign 4
.hword (.Le410 - .Lb410) / 2, 0
.Lb410:
sub.w r9, r0, #0x7f8
.Le410:
.balign 4
.hword (.Le411 - .Lb411) / 2, 0
.Lb411:
sub.w r10, lr, #0x000001fe
.Le411:
.balign 4
.hword (.Le412 - .Lb412) / 2, 0
.Lb412:
subs.w r12, r5, #0
.Le412:
.balign 4
.hword (.Le413 - .Lb413) / 2, 0
.Lb413:
subs.w r11, lr, #1
.Le413:
.balign 4
.hword (.Le414 - .Lb414) / 2, 0
.Lb414:
subs.w r5, r12, #0xff
.Le414:
.balign 4
.hword (.Le415 - .Lb415) / 2, 0
.Lb415:
subs.w r9, lr, #0x00ab00ab
.Le415:
.balign 4
.hword (.Le416 - .Lb416) / 2, 0
.Lb416:
subs.w r11, r5, #0xcd00cd00
.Le416:
.balign 4
.hword (.Le417 - .Lb417) / 2, 0
.Lb417:
subs.w r10, r5, #0x5e5e5e5e
.Le417:
.balign 4
.hword (.Le418 - .Lb418) / 2, 0
.Lb418:
subs.w r11, r11, #0x80000000
.Le418:
.balign 4
.hword (.Le419 - .Lb419) / 2, 0
.Lb419:
subs.w r10, r10, #0xff000000
.Le419:
.balign 4
.hword (.Le420 - .Lb420) / 2, 0
.Lb420:
subs.w r11, r12, #0x3fc00
.Le420:
.balign 4
.hword (.Le421 - .Lb421) / 2, 0
.Lb421:
subs.w lr, r0, #0x104
.Le421:
.balign 4
.hword (.Le422 - .Lb422) / 2, 0
.Lb422:
subs.w r5, r10, #0x7f8
.Le422:
.balign 4
.hword (.Le423 - .Lb423) / 2, 0
.Lb423:
subs.w r9, r3, #0x000001fe
.Le423:
.balign 4
.hword 0xffff, 0
.balign 4
group_sub_reg:
.balign 4
.hword (.Le424 - .Lb424) / 2, 0
.Lb424:
sub.w r12, r9, r5
.Le424:
.balign 4
.hword (.Le425 - .Lb425) / 2, 0
.Lb425:
sub.w lr, r12, r9, lsl #1
.Le425:
.balign 4
.hword (.Le426 - .Lb426) / 2, 0
.Lb426:
sub.w r3, r3, r5, lsl #7
.Le426:
.balign 4
.hword (.Le427 - .Lb427) / 2, 0
.Lb427:
sub.w r0, r0, r12, lsl #31
.Le427:
.balign 4
.hword (.Le428 - .Lb428) / 2, 0
.Lb428:
sub.w r12, r12, r5, lsr #1
.Le428:
.balign 4
.hword (.Le429 - .Lb429) / 2, 0
.Lb429:
sub.w r5, r3, r9, lsr #32
.Le429:
.balign 4
.hword (.Le430 - .Lb430) / 2, 0
.Lb430:
sub.w r12, r5, r10, lsr #13
.Le430:
.balign 4
.hword (.Le431 - .Lb431) / 2, 0
.Lb431:
sub.w r9, r12, r11, asr #1
.Le431:
.balign 4
.hword (.Le432 - .Lb432) / 2, 0
.Lb432:
sub.w r5, r9, r10, asr #32
.Le432:
.balign 4
.hword (.Le433 - .Lb433) / 2, 0
.Lb433:
sub.w r5, r11, lr, asr #20
.Le433:
.balign 4
.hword (.Le434 - .Lb434) / 2, 0
.Lb434:
sub.w r10, r3, r10, ror #1
.Le434:
.balign 4
.hword (.Le435 - .Lb435) / 2, 0
.Lb435:
sub.w r9, lr, r0, ror #31
.Le435:
.balign 4
.hword (.Le436 - .Lb436) / 2, 0
.Lb436:
sub.w r10, r3, r11, rrx
.Le436:
.balign 4
.hword (.Le437 - .Lb437) / 2, 0
.Lb437:
subs.w lr, r10, r0
.Le437:
.balign 4
.hword (.Le438 - .Lb438) / 2, 0
.Lb438:
subs.w r0, r11, r5, lsl #1
.Le438:
.balign 4
.hword (.Le439 - .Lb439) / 2, 0
.Lb439:
subs.w r5, r3, r3, lsl #7
.Le439:
.balign 4
.hword (.Le440 - .Lb440) / 2, 0
.Lb440:
subs.w r12, r9, r9, lsl #31
.Le440:
.balign 4
.hword (.Le441 - .Lb441) / 2, 0
.Lb441:
subs.w r12, r3, r9, lsr #1
.Le441:
.balign 4
.hword (.Le442 - .Lb442) / 2, 0
.Lb442:
subs.w r12, r5, r10, lsr #32
.Le442:
.balign 4
.hword (.Le443 - .Lb443) / 2, 0
.Lb443:
subs.w r0, r3, r9, lsr #13
.Le443:
.balign 4
.hword (.Le444 - .Lb444) / 2, 0
.Lb444:
subs.w r12, lr, r9, asr #1
.Le444:
.balign 4
.hword (.Le445 - .Lb445) / 2, 0
.Lb445:
subs.w r10, r0, r5, asr #32
.Le445:
.balign 4
.hword (.Le446 - .Lb446) / 2, 0
.Lb446:
subs.w r9, r12, r10, asr #20
.Le446:
.balign 4
.hword (.Le447 - .Lb447) / 2, 0
.Lb447:
subs.w r12, r12, r10, ror #1
.Le447:
.balign 4
.hword (.Le448 - .Lb448) / 2, 0
.Lb448:
subs.w lr, r3, r5, ror #31
.Le448:
.balign 4
.hword (.Le449 - .Lb449) / 2, 0
.Lb449:
subs.w r5, r0, lr, rrx
.Le449:
.balign 4
.hword 0xffff, 0
.balign 4
group_rsb_imm:
.balign 4
.hword (.Le450 - .Lb450) / 2, 0
.Lb450:
rsb r0, lr, #0
.Le450:
.balign 4
.hword (.Le451 - .Lb451) / 2, 0
.Lb451:
rsb r12, r11, #1
.Le451:
.balign 4
.hword (.Le452 - .Lb452) / 2, 0
.Lb452:
rsb r3, r3, #0xff
.Le452:
.balign 4
.hword (.Le453 - .Lb453) / 2, 0
.Lb453:
rsb r12, lr, #0x00ab00ab
.Le453:
.balign 4
.hword (.Le454 - .Lb454) / 2, 0
.Lb454:
rsb r5, r9, #0xcd00cd00
.Le454:
.balign 4
.hword (.Le455 - .Lb455) / 2, 0
.Lb455:
rsb r11, r9, #0x5e5e5e5e
.Le455:
.balign 4
.hword (.Le456 - .Lb456) / 2, 0
.Lb456:
rsb r11, r3, #0x80000000
.Le456:
.balign 4
.hword (.Le457 - .Lb457) / 2, 0
.Lb457:
rsb r0, lr, #0xff000000
.Le457:
.balign 4
.hword (.Le458 - .Lb458) / 2, 0
.Lb458:
rsb r5, r5, #0x3fc00
.Le458:
.balign 4
.hword (.Le459 - .Lb459) / 2, 0
.Lb459:
rsb lr, r0, #0x104
.Le459:
.balign 4
.hword (.Le460 - .Lb460) / 2, 0
.Lb460:
rsb r12, r3, #0x7f8
.Le460:
.balign 4
.hword (.Le461 - .Lb461) / 2, 0
.Lb461:
rsb r10, r12, #0x000001fe
.Le461:
.balign 4
.hword (.Le462 - .Lb462) / 2, 0
.Lb462:
rsbs r11, lr, #0
.Le462:
.balign 4
.hword (.Le463 - .Lb463) / 2, 0
.Lb463:
rsbs lr, r0, #1
.Le463:
.balign 4
.hword (.Le464 - .Lb464) / 2, 0
.Lb464:
rsbs r10, r11, #0xff
.Le464:
.balign 4
.hword (.Le465 - .Lb465) / 2, 0
.Lb465:
rsbs r10, r3, #0x00ab00ab
.Le465:
.balign 4
.hword (.Le466 - .Lb466) / 2, 0
.Lb466:
rsbs r12, r12, #0xcd00cd00
.Le466:
.balign 4
.hword (.Le467 - .Lb467) / 2, 0
.Lb467:
rsbs r3, r0, #0x5e5e5e5e
.Le467:
.balign 4
.hword (.Le468 - .Lb468) / 2, 0
.Lb468:
rsbs r3, r11, #0x80000000
.Le468:
.balign 4
.hword (.Le469 - .Lb469) / 2, 0
.Lb469:
rsbs r11, r0, #0xff000000
.Le469:
.balign 4
.hword (.Le470 - .Lb470) / 2, 0
.Lb470:
rsbs r3, lr, #0x3fc00
.Le470:
.balign 4
.hword (.Le471 - .Lb471) / 2, 0
.Lb471:
rsbs lr, r11, #0x104
.Le471:
.balign 4
.hword (.Le472 - .Lb472) / 2, 0
.Lb472:
rsbs r5, r11, #0x7f8
.Le472:
.balign 4
.hword (.Le473 - .Lb473) / 2, 0
.Lb473:
rsbs r9, r5, #0x000001fe
.Le473:
.balign 4
.hword 0xffff, 0
.balign 4
group_rsb_reg:
.balign 4
.hword (.Le474 - .Lb474) / 2, 0
.Lb474:
rsb.w r3, r12, r11
.Le474:
.balign 4
.hword (.Le475 - .Lb475) / 2, 0
.Lb475:
rsb.w r12, r11, r11, lsl #1
.Le475:
.balign 4
.hword (.Le476 - .Lb476) / 2, 0
.Lb476:
rsb.w r10, r11, r0, lsl #7
.Le476:
.balign 4
.hword (.Le477 - .Lb477) / 2, 0
.Lb477:
rsb.w r3, r9, r10, lsl #31
.Le477:
.balign 4
.hword (.Le478 - .Lb478) / 2, 0
.Lb478:
rsb.w r12, r10, r3, lsr #1
.Le478:
.balign 4
.hword (.Le479 - .Lb479) / 2, 0
.Lb479:
rsb.w r3, r5, r10, lsr #32
.Le479:
.balign 4
.hword (.Le480 - .Lb480) / 2, 0
.Lb480:
rsb.w r12, r3, r5, lsr #13
.Le480:
.balign 4
.hword (.Le481 - .Lb481) / 2, 0
.Lb481:
rsb.w r10, r10, r9, asr #1
.Le481:
.balign 4
.hword (.Le482 - .Lb482) / 2, 0
.Lb482:
rsb.w r9, r3, r10, asr #32
.Le482:
.balign 4
.hword (.Le483 - .Lb483) / 2, 0
.Lb483:
rsb.w lr, r0, r10, asr #20
.Le483:
.balign 4
.hword (.Le484 - .Lb484) / 2, 0
.Lb484:
rsb.w r9, r3, r11, ror #1
.Le484:
.balign 4
.hword (.Le485 - .Lb485) / 2, 0
.Lb485:
rsb.w r11, r10, r5, ror #31
.Le485:
.balign 4
.hword (.Le486 - .Lb486) / 2, 0
.Lb486:
rsb.w r0, lr, r11, rrx
.Le486:
.balign 4
.hword (.Le487 - .Lb487) / 2, 0
.Lb487:
rsbs.w r0, r0, r11
.Le487:
.balign 4
.hword (.Le488 - .Lb488) / 2, 0
.Lb488:
rsbs.w r12, r5, r0, lsl #1
.Le488:
.balign 4
.hword (.Le489 - .Lb489) / 2, 0
.Lb489:
rsbs.w r12, r5, r9, lsl #7
.Le489:
.balign 4
.hword (.Le490 - .Lb490) / 2, 0
.Lb490:
rsbs.w r9, r3, r5, lsl #31
.Le490:
.balign 4
.hword (.Le491 - .Lb491) / 2, 0
.Lb491:
rsbs.w r3, r10, lr, lsr #1
.Le491:
.balign 4
.hword (.Le492 - .Lb492) / 2, 0
.Lb492:
rsbs.w r9, r0, r11, lsr #32
.Le492:
.balign 4
.hword (.Le493 - .Lb493) / 2, 0
.Lb493:
rsbs.w lr, r11, r11, lsr #13
.Le493:
.balign 4
.hword (.Le494 - .Lb494) / 2, 0
.Lb494:
rsbs.w r9, r0, r0, asr #1
.Le494:
.balign 4
.hword (.Le495 - .Lb495) / 2, 0
.Lb495:
rsbs.w lr, r0, r5, asr #32
.Le495:
.balign 4
.hword (.Le496 - .Lb496) / 2, 0
.Lb496:
rsbs.w r10, r0, r0, asr #20
.Le496:
.balign 4
.hword (.Le497 - .Lb497) / 2, 0
.Lb497:
rsbs.w r9, r3, r5, ror #1
.Le497:
.balign 4
.hword (.Le498 - .Lb498) / 2, 0
.Lb498:
rsbs.w r0, r9, r9, ror #31
.Le498:
.balign 4
.hword (.Le499 - .Lb499) / 2, 0
.Lb499:
rsbs.w lr, r10, r9, rrx
.Le499:
.balign 4
.hword 0xffff, 0
.balign 4
group_mov_imm:
.balign 4
.hword (.Le500 - .Lb500) / 2, 0
.Lb500:
mov.w lr, #0
.Le500:
.balign 4
.hword (.Le501 - .Lb501) / 2, 0
.Lb501:
mov.w r12, #1
.Le501:
.balign 4
.hword (.Le502 - .Lb502) / 2, 0
.Lb502:
mov.w r5, #0xff
.Le502:
.balign 4
.hword (.Le503 - .Lb503) / 2, 0
.Lb503:
mov.w r12, #0x00ab00ab
.Le503:
.balign 4
.hword (.Le504 - .Lb504) / 2, 0
.Lb504:
mov.w r0, #0xcd00cd00
.Le504:
.balign 4
.hword (.Le505 - .Lb505) / 2, 0
.Lb505:
mov.w r3, #0x5e5e5e5e
.Le505:
.balign 4
.hword (.Le506 - .Lb506) / 2, 0
.Lb506:
mov.w r11, #0x80000000
.Le506:
.balign 4
.hword (.Le507 - .Lb507) / 2, 0
.Lb507:
mov.w r9, #0xff000000
.Le507:
.balign 4
.hword (.Le508 - .Lb508) / 2, 0
.Lb508:
mov.w lr, #0x3fc00
.Le508:
.balign 4
.hword (.Le509 - .Lb509) / 2, 0
.Lb509:
mov.w r10, #0x104
.Le509:
.balign 4
.hword (.Le510 - .Lb510) / 2, 0
.Lb510:
mov.w r10, #0x7f8
.Le510:
.balign 4
.hword (.Le511 - .Lb511) / 2, 0
.Lb511:
mov.w r0, #0x000001fe
.Le511:
.balign 4
.hword (.Le512 - .Lb512) / 2, 0
.Lb512:
movs.w lr, #0
.Le512:
.balign 4
.hword (.Le513 - .Lb513) / 2, 0
.Lb513:
movs.w lr, #1
.Le513:
.balign 4
.hword (.Le514 - .Lb514) / 2, 0
.Lb514:
movs.w r11, #0xff
.Le514:
.balign 4
.hword (.Le515 - .Lb515) / 2, 0
.Lb515:
movs.w r12, #0x00ab00ab
.Le515:
.balign 4
.hword (.Le516 - .Lb516) / 2, 0
.Lb516:
movs.w r11, #0xcd00cd00
.Le516:
.balign 4
.hword (.Le517 - .Lb517) / 2, 0
.Lb517:
movs.w r0, #0x5e5e5e5e
.Le517:
.balign 4
.hword (.Le518 - .Lb518) / 2, 0
.Lb518:
movs.w r0, #0x80000000
.Le518:
.balign 4
.hword (.Le519 - .Lb519) / 2, 0
.Lb519:
movs.w r10, #0xff000000
.Le519:
.balign 4
.hword (.Le520 - .Lb520) / 2, 0
.Lb520:
movs.w r3, #0x3fc00
.Le520:
.balign 4
.hword (.Le521 - .Lb521) / 2, 0
.Lb521:
movs.w r3, #0x104
.Le521:
.balign 4
.hword (.Le522 - .Lb522) / 2, 0
.Lb522:
movs.w r12, #0x7f8
.Le522:
.balign 4
.hword (.Le523 - .Lb523) / 2, 0
.Lb523:
movs.w r0, #0x000001fe
.Le523:
.balign 4
.hword 0xffff, 0
.balign 4
group_mov_reg:
.balign 4
.hword (.Le524 - .Lb524) / 2, 0
.Lb524:
mov.w r10, r12
.Le524:
.balign 4
.hword (.Le525 - .Lb525) / 2, 0
.Lb525:
movs.w r12, r3
.Le525:
.balign 4
.hword 0xffff, 0
.balign 4
group_mvn_imm:
.balign 4
.hword (.Le526 - .Lb526) / 2, 0
.Lb526:
mvn.w r9, #0
.Le526:
.balign 4
.hword (.Le527 - .Lb527) / 2, 0
.Lb527:
mvn.w r0, #1
.Le527:
.balign 4
.hword (.Le528 - .Lb528) / 2, 0
.Lb528:
mvn.w r9, #0xff
.Le528:
.balign 4
.hword (.Le529 - .Lb529) / 2, 0
.Lb529:
mvn.w r9, #0x00ab00ab
.Le529:
.balign 4
.hword (.Le530 - .Lb530) / 2, 0
.Lb530:
mvn.w r11, #0xcd00cd00
.Le530:
.balign 4
.hword (.Le531 - .Lb531) / 2, 0
.Lb531:
mvn.w lr, #0x5e5e5e5e
.Le531:
.balign 4
.hword (.Le532 - .Lb532) / 2, 0
.Lb532:
mvn.w r5, #0x80000000
.Le532:
.balign 4
.hword (.Le533 - .Lb533) / 2, 0
.Lb533:
mvn.w r12, #0xff000000
.Le533:
.balign 4
.hword (.Le534 - .Lb534) / 2, 0
.Lb534:
mvn.w r11, #0x3fc00
.Le534:
.balign 4
.hword (.Le535 - .Lb535) / 2, 0
.Lb535:
mvn.w r10, #0x104
.Le535:
.balign 4
.hword (.Le536 - .Lb536) / 2, 0
.Lb536:
mvn.w r10, #0x7f8
.Le536:
.balign 4
.hword (.Le537 - .Lb537) / 2, 0
.Lb537:
mvn.w r3, #0x000001fe
.Le537:
.balign 4
.hword (.Le538 - .Lb538) / 2, 0
.Lb538:
mvns.w r12, #0
.Le538:
.balign 4
.hword (.Le539 - .Lb539) / 2, 0
.Lb539:
mvns.w r0, #1
.Le539:
.balign 4
.hword (.Le540 - .Lb540) / 2, 0
.Lb540:
mvns.w r5, #0xff
.Le540:
.balign 4
.hword (.Le541 - .Lb541) / 2, 0
.Lb541:
mvns.w r3, #0x00ab00ab
.Le541:
.balign 4
.hword (.Le542 - .Lb542) / 2, 0
.Lb542:
mvns.w r0, #0xcd00cd00
.Le542:
.balign 4
.hword (.Le543 - .Lb543) / 2, 0
.Lb543:
mvns.w r3, #0x5e5e5e5e
.Le543:
.balign 4
.hword (.Le544 - .Lb544) / 2, 0
.Lb544:
mvns.w r0, #0x80000000
.Le544:
.balign 4
.hword (.Le545 - .Lb545) / 2, 0
.Lb545:
mvns.w r0, #0xff000000
.Le545:
.balign 4
.hword (.Le546 - .Lb546) / 2, 0
.Lb546:
mvns.w lr, #0x3fc00
.Le546:
.balign 4
.hword (.Le547 - .Lb547) / 2, 0
.Lb547:
mvns.w r10, #0x104
.Le547:
.balign 4
.hword (.Le548 - .Lb548) / 2, 0
.Lb548:
mvns.w r5, #0x7f8
.Le548:
.balign 4
.hword (.Le549 - .Lb549) / 2, 0
.Lb549:
mvns.w r0, #0x000001fe
.Le549:
.balign 4
.hword 0xffff, 0
.balign 4
group_mvn_reg:
.balign 4
.hword (.Le550 - .Lb550) / 2, 0
.Lb550:
mvn.w r0, r11
.Le550:
.balign 4
.hword (.Le551 - .Lb551) / 2, 0
.Lb551:
mvn.w r12, r0, lsl #1
.Le551:
.balign 4
.hword (.Le552 - .Lb552) / 2, 0
.Lb552:
mvn.w r5, r5, lsl #7
.Le552:
.balign 4
.hword (.Le553 - .Lb553) / 2, 0
.Lb553:
mvn.w r9, r5, lsl #31
.Le553:
.balign 4
.hword (.Le554 - .Lb554) / 2, 0
.Lb554:
mvn.w r10, r0, lsr #1
.Le554:
.balign 4
.hword (.Le555 - .Lb555) / 2, 0
.Lb555:
mvn.w r11, r3, lsr #32
.Le555:
.balign 4
.hword (.Le556 - .Lb556) / 2, 0
.Lb556:
mvn.w lr, r9, lsr #13
.Le556:
.balign 4
.hword (.Le557 - .Lb557) / 2, 0
.Lb557:
mvn.w r0, r11, asr #1
.Le557:
.balign 4
.hword (.Le558 - .Lb558) / 2, 0
.Lb558:
mvn.w r0, lr, asr #32
.Le558:
.balign 4
.hword (.Le559 - .Lb559) / 2, 0
.Lb559:
mvn.w r9, r5, asr #20
.Le559:
.balign 4
.hword (.Le560 - .Lb560) / 2, 0
.Lb560:
mvn.w r3, r9, ror #1
.Le560:
.balign 4
.hword (.Le561 - .Lb561) / 2, 0
.Lb561:
mvn.w r0, r3, ror #31
.Le561:
.balign 4
.hword (.Le562 - .Lb562) / 2, 0
.Lb562:
mvn.w r9, r10, rrx
.Le562:
.balign 4
.hword (.Le563 - .Lb563) / 2, 0
.Lb563:
mvns.w r12, r0
.Le563:
.balign 4
.hword (.Le564 - .Lb564) / 2, 0
.Lb564:
mvns.w r10, r11, lsl #1
.Le564:
.balign 4
.hword (.Le565 - .Lb565) / 2, 0
.Lb565:
mvns.w r11, lr, lsl #7
.Le565:
.balign 4
.hword (.Le566 - .Lb566) / 2, 0
.Lb566:
mvns.w r12, r3, lsl #31
.Le566:
.balign 4
.hword (.Le567 - .Lb567) / 2, 0
.Lb567:
mvns.w r12, lr, lsr #1
.Le567:
.balign 4
.hword (.Le568 - .Lb568) / 2, 0
.Lb568:
mvns.w r11, r3, lsr #32
.Le568:
.balign 4
.hword (.Le569 - .Lb569) / 2, 0
.Lb569:
mvns.w r9, r12, lsr #13
.Le569:
.balign 4
.hword (.Le570 - .Lb570) / 2, 0
.Lb570:
mvns.w r10, r11, asr #1
.Le570:
.balign 4
.hword (.Le571 - .Lb571) / 2, 0
.Lb571:
mvns.w r11, lr, asr #32
.Le571:
.balign 4
.hword (.Le572 - .Lb572) / 2, 0
.Lb572:
mvns.w r11, r11, asr #20
.Le572:
.balign 4
.hword (.Le573 - .Lb573) / 2, 0
.Lb573:
mvns.w r12, r0, ror #1
.Le573:
.balign 4
.hword (.Le574 - .Lb574) / 2, 0
.Lb574:
mvns.w r11, r10, ror #31
.Le574:
.balign 4
.hword (.Le575 - .Lb575) / 2, 0
.Lb575:
mvns.w r5, r5, rrx
.Le575:
.balign 4
.hword 0xffff, 0
.balign 4
group_tst_imm:
.balign 4
.hword (.Le576 - .Lb576) / 2, 0
.Lb576:
tst r5, #0
.Le576:
.balign 4
.hword (.Le577 - .Lb577) / 2, 0
.Lb577:
tst r5, #1
.Le577:
.balign 4
.hword (.Le578 - .Lb578) / 2, 0
.Lb578:
tst r10, #0xff
.Le578:
.balign 4
.hword (.Le579 - .Lb579) / 2, 0
.Lb579:
tst r11, #0x00ab00ab
.Le579:
.balign 4
.hword (.Le580 - .Lb580) / 2, 0
.Lb580:
tst lr, #0xcd00cd00
.Le580:
.balign 4
.hword (.Le581 - .Lb581) / 2, 0
.Lb581:
tst r12, #0x5e5e5e5e
.Le581:
.balign 4
.hword (.Le582 - .Lb582) / 2, 0
.Lb582:
tst lr, #0x80000000
.Le582:
.balign 4
.hword (.Le583 - .Lb583) / 2, 0
.Lb583:
tst r11, #0xff000000
.Le583:
.balign 4
.hword (.Le584 - .Lb584) / 2, 0
.Lb584:
tst lr, #0x3fc00
.Le584:
.balign 4
.hword (.Le585 - .Lb585) / 2, 0
.Lb585:
tst r9, #0x104
.Le585:
.balign 4
.hword (.Le586 - .Lb586) / 2, 0
.Lb586:
tst r11, #0x7f8
.Le586:
.balign 4
.hword (.Le587 - .Lb587) / 2, 0
.Lb587:
tst r3, #0x000001fe
.Le587:
.balign 4
.hword 0xffff, 0
.balign 4
group_tst_reg:
.balign 4
.hword (.Le588 - .Lb588) / 2, 0
.Lb588:
tst.w r0, r10
.Le588:
.balign 4
.hword (.Le589 - .Lb589) / 2, 0
.Lb589:
tst.w r0, r9, lsl #1
.Le589:
.balign 4
.hword (.Le590 - .Lb590) / 2, 0
.Lb590:
tst.w r11, r12, lsl #7
.Le590:
.balign 4
.hword (.Le591 - .Lb591) / 2, 0
.Lb591:
tst.w r11, r0, lsl #31
.Le591:
.balign 4
.hword (.Le592 - .Lb592) / 2, 0
.Lb592:
tst.w r10, r0, lsr #1
.Le592:
.balign 4
.hword (.Le593 - .Lb593) / 2, 0
.Lb593:
tst.w r3, r5, lsr #32
.Le593:
.balign 4
.hword (.Le594 - .Lb594) / 2, 0
.Lb594:
tst.w r11, r10, lsr #13
.Le594:
.balign 4
.hword (.Le595 - .Lb595) / 2, 0
.Lb595:
tst.w r5, r9, asr #1
.Le595:
.balign 4
.hword (.Le596 - .Lb596) / 2, 0
.Lb596:
tst.w r10, r12, asr #32
.Le596:
.balign 4
.hword (.Le597 - .Lb597) / 2, 0
.Lb597:
tst.w lr, r5, asr #20
.Le597:
.balign 4
.hword (.Le598 - .Lb598) / 2, 0
.Lb598:
tst.w r9, r12, ror #1
.Le598:
.balign 4
.hword (.Le599 - .Lb599) / 2, 0
.Lb599:
tst.w r10, r9, ror #31
.Le599:
.balign 4
.hword (.Le600 - .Lb600) / 2, 0
.Lb600:
tst.w r5, r5, rrx
.Le600:
.balign 4
.hword 0xffff, 0
.balign 4
group_teq_imm:
.balign 4
.hword (.Le601 - .Lb601) / 2, 0
.Lb601:
teq r0, #0
.Le601:
.balign 4
.hword (.Le602 - .Lb602) / 2, 0
.Lb602:
teq r11, #1
.Le602:
.balign 4
.hword (.Le603 - .Lb603) / 2, 0
.Lb603:
teq r11, #0xff
.Le603:
.balign 4
.hword (.Le604 - .Lb604) / 2, 0
.Lb604:
teq r9, #0x00ab00ab
.Le604:
.balign 4
.hword (.Le605 - .Lb605) / 2, 0
.Lb605:
teq r9, #0xcd00cd00
.Le605:
.balign 4
.hword (.Le606 - .Lb606) / 2, 0
.Lb606:
teq r0, #0x5e5e5e5e
.Le606:
.balign 4
.hword (.Le607 - .Lb607) / 2, 0
.Lb607:
teq lr, #0x80000000
.Le607:
.balign 4
.hword (.Le608 - .Lb608) / 2, 0
.Lb608:
teq r11, #0xff000000
.Le608:
.balign 4
.hword (.Le609 - .Lb609) / 2, 0
.Lb609:
teq r5, #0x3fc00
.Le609:
.balign 4
.hword (.Le610 - .Lb610) / 2, 0
.Lb610:
teq r11, #0x104
.Le610:
.balign 4
.hword (.Le611 - .Lb611) / 2, 0
.Lb611:
teq r3, #0x7f8
.Le611:
.balign 4
.hword (.Le612 - .Lb612) / 2, 0
.Lb612:
teq r12, #0x000001fe
.Le612:
.balign 4
.hword 0xffff, 0
.balign 4
group_teq_reg:
.balign 4
.hword (.Le613 - .Lb613) / 2, 0
.Lb613:
teq.w r3, r11
.Le613:
.balign 4
.hword (.Le614 - .Lb614) / 2, 0
.Lb614:
teq.w r5, r11, lsl #1
.Le614:
.balign 4
.hword (.Le615 - .Lb615) / 2, 0
.Lb615:
teq.w r11, r10, lsl #7
.Le615:
.balign 4
.hword (.Le616 - .Lb616) / 2, 0
.Lb616:
teq.w r10, lr, lsl #31
.Le616:
.balign 4
.hword (.Le617 - .Lb617) / 2, 0
.Lb617:
teq.w r0, r10, lsr #1
.Le617:
.balign 4
.hword (.Le618 - .Lb618) / 2, 0
.Lb618:
teq.w r10, r0, lsr #32
.Le618:
.balign 4
.hword (.Le619 - .Lb619) / 2, 0
.Lb619:
teq.w r12, r12, lsr #13
.Le619:
.balign 4
.hword (.Le620 - .Lb620) / 2, 0
.Lb620:
teq.w r10, r11, asr #1
.Le620:
.balign 4
.hword (.Le621 - .Lb621) / 2, 0
.Lb621:
teq.w r10, r10, asr #32
.Le621:
.balign 4
.hword (.Le622 - .Lb622) / 2, 0
.Lb622:
teq.w r11, r5, asr #20
.Le622:
.balign 4
.hword (.Le623 - .Lb623) / 2, 0
.Lb623:
teq.w r3, r12, ror #1
.Le623:
.balign 4
.hword (.Le624 - .Lb624) / 2, 0
.Lb624:
teq.w r9, r12, ror #31
.Le624:
.balign 4
.hword (.Le625 - .Lb625) / 2, 0
.Lb625:
teq.w r5, lr, rrx
.Le625:
.balign 4
.hword 0xffff, 0
.balign 4
group_cmp_imm:
.balign 4
.hword (.Le626 - .Lb626) / 2, 0
.Lb626:
cmp.w r0, #0
.Le626:
.balign 4
.hword (.Le627 - .Lb627) / 2, 0
.Lb627:
cmp.w r3, #1
.Le627:
.balign 4
.hword (.Le628 - .Lb628) / 2, 0
.Lb628:
cmp.w lr, #0xff
.Le628:
.balign 4
.hword (.Le629 - .Lb629) / 2, 0
.Lb629:
cmp.w lr, #0x00ab00ab
.Le629:
.balign 4
.hword (.Le630 - .Lb630) / 2, 0
.Lb630:
cmp.w r12, #0xcd00cd00
.Le630:
.balign 4
.hword (.Le631 - .Lb631) / 2, 0
.Lb631:
cmp.w r11, #0x5e5e5e5e
.Le631:
.balign 4
.hword (.Le632 - .Lb632) / 2, 0
.Lb632:
cmp.w r11, #0x80000000
.Le632:
.balign 4
.hword (.Le633 - .Lb633) / 2, 0
.Lb633:
cmp.w r10, #0xff000000
.Le633:
.balign 4
.hword (.Le634 - .Lb634) / 2, 0
.Lb634:
cmp.w r11, #0x3fc00
.Le634:
.balign 4
.hword (.Le635 - .Lb635) / 2, 0
.Lb635:
cmp.w r5, #0x104
.Le635:
.balign 4
.hword (.Le636 - .Lb636) / 2, 0
.Lb636:
cmp.w r11, #0x7f8
.Le636:
.balign 4
.hword (.Le637 - .Lb637) / 2, 0
.Lb637:
cmp.w lr, #0x000001fe
.Le637:
.balign 4
.hword 0xffff, 0
.balign 4
group_cmp_reg:
.balign 4
.hword (.Le638 - .Lb638) / 2, 0
.Lb638:
cmp.w r9, r0
.Le638:
.balign 4
.hword (.Le639 - .Lb639) / 2, 0
.Lb639:
cmp.w r5, r9, lsl #1
.Le639:
.balign 4
.hword (.Le640 - .Lb640) / 2, 0
.Lb640:
cmp.w lr, r3, lsl #7
.Le640:
.balign 4
.hword (.Le641 - .Lb641) / 2, 0
.Lb641:
cmp.w r10, r5, lsl #31
.Le641:
.balign 4
.hword (.Le642 - .Lb642) / 2, 0
.Lb642:
cmp.w r11, r5, lsr #1
.Le642:
.balign 4
.hword (.Le643 - .Lb643) / 2, 0
.Lb643:
cmp.w r10, r9, lsr #32
.Le643:
.balign 4
.hword (.Le644 - .Lb644) / 2, 0
.Lb644:
cmp.w lr, lr, lsr #13
.Le644:
.balign 4
.hword (.Le645 - .Lb645) / 2, 0
.Lb645:
cmp.w r5, r10, asr #1
.Le645:
.balign 4
.hword (.Le646 - .Lb646) / 2, 0
.Lb646:
cmp.w r10, r5, asr #32
.Le646:
.balign 4
.hword (.Le647 - .Lb647) / 2, 0
.Lb647:
cmp.w r11, r3, asr #20
.Le647:
.balign 4
.hword (.Le648 - .Lb648) / 2, 0
.Lb648:
cmp.w r12, r5, ror #1
.Le648:
.balign 4
.hword (.Le649 - .Lb649) / 2, 0
.Lb649:
cmp.w lr, lr, ror #31
.Le649:
.balign 4
.hword (.Le650 - .Lb650) / 2, 0
.Lb650:
cmp.w r9, r0, rrx
.Le650:
.balign 4
.hword 0xffff, 0
.balign 4
group_cmn_imm:
.balign 4
.hword (.Le651 - .Lb651) / 2, 0
.Lb651:
cmn r3, #0
.Le651:
.balign 4
.hword (.Le652 - .Lb652) / 2, 0
.Lb652:
cmn r5, #1
.Le652:
.balign 4
.hword (.Le653 - .Lb653) / 2, 0
.Lb653:
cmn r5, #0xff
.Le653:
.balign 4
.hword (.Le654 - .Lb654) / 2, 0
.Lb654:
cmn r0, #0x00ab00ab
.Le654:
.balign 4
.hword (.Le655 - .Lb655) / 2, 0
.Lb655:
cmn lr, #0xcd00cd00
.Le655:
.balign 4
.hword (.Le656 - .Lb656) / 2, 0
.Lb656:
cmn r11, #0x5e5e5e5e
.Le656:
.balign 4
.hword (.Le657 - .Lb657) / 2, 0
.Lb657:
cmn r5, #0x80000000
.Le657:
.balign 4
.hword (.Le658 - .Lb658) / 2, 0
.Lb658:
cmn r3, #0xff000000
.Le658:
.balign 4
.hword (.Le659 - .Lb659) / 2, 0
.Lb659:
cmn r11, #0x3fc00
.Le659:
.balign 4
.hword (.Le660 - .Lb660) / 2, 0
.Lb660:
cmn r3, #0x104
.Le660:
.balign 4
.hword (.Le661 - .Lb661) / 2, 0
.Lb661:
cmn lr, #0x7f8
.Le661:
.balign 4
.hword (.Le662 - .Lb662) / 2, 0
.Lb662:
cmn lr, #0x000001fe
.Le662:
.balign 4
.hword 0xffff, 0
.balign 4
group_cmn_reg:
.balign 4
.hword (.Le663 - .Lb663) / 2, 0
.Lb663:
cmn.w r5, r12
.Le663:
.balign 4
.hword (.Le664 - .Lb664) / 2, 0
.Lb664:
cmn.w lr, r5, lsl #1
.Le664:
.balign 4
.hword (.Le665 - .Lb665) / 2, 0
.Lb665:
cmn.w r5, r11, lsl #7
.Le665:
.balign 4
.hword (.Le666 - .Lb666) / 2, 0
.Lb666:
cmn.w r9, r9, lsl #31
.Le666:
.balign 4
.hword (.Le667 - .Lb667) / 2, 0
.Lb667:
cmn.w lr, r5, lsr #1
.Le667:
.balign 4
.hword (.Le668 - .Lb668) / 2, 0
.Lb668:
cmn.w r3, r12, lsr #32
.Le668:
.balign 4
.hword (.Le669 - .Lb669) / 2, 0
.Lb669:
cmn.w lr, r5, lsr #13
.Le669:
.balign 4
.hword (.Le670 - .Lb670) / 2, 0
.Lb670:
cmn.w r11, r10, asr #1
.Le670:
.balign 4
.hword (.Le671 - .Lb671) / 2, 0
.Lb671:
cmn.w r0, r12, asr #32
.Le671:
.balign 4
.hword (.Le672 - .Lb672) / 2, 0
.Lb672:
cmn.w lr, r10, asr #20
.Le672:
.balign 4
.hword (.Le673 - .Lb673) / 2, 0
.Lb673:
cmn.w r12, r11, ror #1
.Le673:
.balign 4
.hword (.Le674 - .Lb674) / 2, 0
.Lb674:
cmn.w r5, r3, ror #31
.Le674:
.balign 4
.hword (.Le675 - .Lb675) / 2, 0
.Lb675:
cmn.w r5, lr, rrx
.Le675:
.balign 4
.hword 0xffff, 0
.balign 4
group_shift_wide_imm:
.balign 4
.hword (.Le676 - .Lb676) / 2, 0
.Lb676:
lsl.w r5, r3, #1
.Le676:
.balign 4
.hword (.Le677 - .Lb677) / 2, 0
.Lb677:
lsl.w r3, r11, #2
.Le677:
.balign 4
.hword (.Le678 - .Lb678) / 2, 0
.Lb678:
lsl.w lr, r11, #15
.Le678:
.balign 4
.hword (.Le679 - .Lb679) / 2, 0
.Lb679:
lsl.w lr, lr, #30
.Le679:
.balign 4
.hword (.Le680 - .Lb680) / 2, 0
.Lb680:
lsl.w r12, r5, #31
.Le680:
.balign 4
.hword (.Le681 - .Lb681) / 2, 0
.Lb681:
lsls.w r9, r9, #1
.Le681:
.balign 4
.hword (.Le682 - .Lb682) / 2, 0
.Lb682:
lsls.w r0, r0, #2
.Le682:
.balign 4
.hword (.Le683 - .Lb683) / 2, 0
.Lb683:
lsls.w r11, r0, #15
.Le683:
.balign 4
.hword (.Le684 - .Lb684) / 2, 0
.Lb684:
lsls.w r11, r11, #30
.Le684:
.balign 4
.hword (.Le685 - .Lb685) / 2, 0
.Lb685:
lsls.w r12, r10, #31
.Le685:
.balign 4
.hword (.Le686 - .Lb686) / 2, 0
.Lb686:
lsr.w r9, r12, #1
.Le686:
.balign 4
.hword (.Le687 - .Lb687) / 2, 0
.Lb687:
lsr.w r12, r0, #2
.Le687:
.balign 4
.hword (.Le688 - .Lb688) / 2, 0
.Lb688:
lsr.w r12, r9, #15
.Le688:
.balign 4
.hword (.Le689 - .Lb689) / 2, 0
.Lb689:
lsr.w r9, r11, #30
.Le689:
.balign 4
.hword (.Le690 - .Lb690) / 2, 0
.Lb690:
lsr.w r12, r10, #31
.Le690:
.balign 4
.hword (.Le691 - .Lb691) / 2, 0
.Lb691:
lsrs.w r3, r0, #1
.Le691:
.balign 4
.hword (.Le692 - .Lb692) / 2, 0
.Lb692:
lsrs.w r11, r12, #2
.Le692:
.balign 4
.hword (.Le693 - .Lb693) / 2, 0
.Lb693:
lsrs.w r5, r5, #15
.Le693:
.balign 4
.hword (.Le694 - .Lb694) / 2, 0
.Lb694:
lsrs.w r11, r12, #30
.Le694:
.balign 4
.hword (.Le695 - .Lb695) / 2, 0
.Lb695:
lsrs.w r12, r10, #31
.Le695:
.balign 4
.hword (.Le696 - .Lb696) / 2, 0
.Lb696:
asr.w r9, r5, #1
.Le696:
.balign 4
.hword (.Le697 - .Lb697) / 2, 0
.Lb697:
asr.w r5, r5, #2
.Le697:
.balign 4
.hword (.Le698 - .Lb698) / 2, 0
.Lb698:
asr.w r3, r5, #15
.Le698:
.balign 4
.hword (.Le699 - .Lb699) / 2, 0
.Lb699:
asr.w r12, r11, #30
.Le699:
.balign 4
.hword (.Le700 - .Lb700) / 2, 0
.Lb700:
asr.w r11, r0, #31
.Le700:
.balign 4
.hword (.Le701 - .Lb701) / 2, 0
.Lb701:
asrs.w r11, r9, #1
.Le701:
.balign 4
.hword (.Le702 - .Lb702) / 2, 0
.Lb702:
asrs.w r9, lr, #2
.Le702:
.balign 4
.hword (.Le703 - .Lb703) / 2, 0
.Lb703:
asrs.w r0, r5, #15
.Le703:
.balign 4
.hword (.Le704 - .Lb704) / 2, 0
.Lb704:
asrs.w lr, r9, #30
.Le704:
.balign 4
.hword (.Le705 - .Lb705) / 2, 0
.Lb705:
asrs.w r11, r10, #31
.Le705:
.balign 4
.hword (.Le706 - .Lb706) / 2, 0
.Lb706:
ror.w r11, r12, #1
.Le706:
.balign 4
.hword (.Le707 - .Lb707) / 2, 0
.Lb707:
ror.w lr, lr, #2
.Le707:
.balign 4
.hword (.Le708 - .Lb708) / 2, 0
.Lb708:
ror.w r9, r9, #15
.Le708:
.balign 4
.hword (.Le709 - .Lb709) / 2, 0
.Lb709:
ror.w r0, r0, #30
.Le709:
.balign 4
.hword (.Le710 - .Lb710) / 2, 0
.Lb710:
ror.w r10, r3, #31
.Le710:
.balign 4
.hword (.Le711 - .Lb711) / 2, 0
.Lb711:
rors.w r3, r12, #1
.Le711:
.balign 4
.hword (.Le712 - .Lb712) / 2, 0
.Lb712:
rors.w r11, lr, #2
.Le712:
.balign 4
.hword (.Le713 - .Lb713) / 2, 0
.Lb713:
rors.w lr, r5, #15
.Le713:
.balign 4
.hword (.Le714 - .Lb714) / 2, 0
.Lb714:
rors.w r12, r11, #30
.Le714:
.balign 4
.hword (.Le715 - .Lb715) / 2, 0
.Lb715:
rors.w r12, r12, #31
.Le715:
.balign 4
.hword 0xffff, 0
.balign 4
group_shift_wide_reg:
.balign 4
.hword (.Le716 - .Lb716) / 2, 0
.Lb716:
lsl.w r11, r9, r8
.Le716:
.balign 4
.hword (.Le717 - .Lb717) / 2, 0
.Lb717:
lsl.w r3, r5, r3
.Le717:
.balign 4
.hword (.Le718 - .Lb718) / 2, 0
.Lb718:
lsl.w r9, r0, r11
.Le718:
.balign 4
.hword (.Le719 - .Lb719) / 2, 0
.Lb719:
lsls.w r12, lr, r8
.Le719:
.balign 4
.hword (.Le720 - .Lb720) / 2, 0
.Lb720:
lsls.w r3, r0, r3
.Le720:
.balign 4
.hword (.Le721 - .Lb721) / 2, 0
.Lb721:
lsls.w r0, r0, r11
.Le721:
.balign 4
.hword (.Le722 - .Lb722) / 2, 0
.Lb722:
lsr.w r10, r12, r8
.Le722:
.balign 4
.hword (.Le723 - .Lb723) / 2, 0
.Lb723:
lsr.w r9, r11, r3
.Le723:
.balign 4
.hword (.Le724 - .Lb724) / 2, 0
.Lb724:
lsr.w r11, r0, r11
.Le724:
.balign 4
.hword (.Le725 - .Lb725) / 2, 0
.Lb725:
lsrs.w r5, r11, r8
.Le725:
.balign 4
.hword (.Le726 - .Lb726) / 2, 0
.Lb726:
lsrs.w r11, r3, r3
.Le726:
.balign 4
.hword (.Le727 - .Lb727) / 2, 0
.Lb727:
lsrs.w r3, r12, r11
.Le727:
.balign 4
.hword (.Le728 - .Lb728) / 2, 0
.Lb728:
asr.w r0, r11, r8
.Le728:
.balign 4
.hword (.Le729 - .Lb729) / 2, 0
.Lb729:
asr.w r5, r10, r3
.Le729:
.balign 4
.hword (.Le730 - .Lb730) / 2, 0
.Lb730:
asr.w lr, r0, r11
.Le730:
.balign 4
.hword (.Le731 - .Lb731) / 2, 0
.Lb731:
asrs.w r3, r12, r8
.Le731:
.balign 4
.hword (.Le732 - .Lb732) / 2, 0
.Lb732:
asrs.w lr, r3, r3
.Le732:
.balign 4
.hword (.Le733 - .Lb733) / 2, 0
.Lb733:
asrs.w r12, r12, r11
.Le733:
.balign 4
.hword (.Le734 - .Lb734) / 2, 0
.Lb734:
ror.w r12, lr, r8
.Le734:
.balign 4
.hword (.Le735 - .Lb735) / 2, 0
.Lb735:
ror.w lr, r3, r3
.Le735:
.balign 4
.hword (.Le736 - .Lb736) / 2, 0
.Lb736:
ror.w r9, r11, r11
.Le736:
.balign 4
.hword (.Le737 - .Lb737) / 2, 0
.Lb737:
rors.w r3, r11, r8
.Le737:
.balign 4
.hword (.Le738 - .Lb738) / 2, 0
.Lb738:
rors.w r9, r3, r3
.Le738:
.balign 4
.hword (.Le739 - .Lb739) / 2, 0
.Lb739:
rors.w r0, r12, r11
.Le739:
.balign 4
.hword 0xffff, 0
.balign 4
group_plain_imm:
.balign 4
.hword (.Le740 - .Lb740) / 2, 0
.Lb740:
addw r3, r10, #0
.Le740:
.balign 4
.hword (.Le741 - .Lb741) / 2, 0
.Lb741:
addw r0, r12, #1
.Le741:
.balign 4
.hword (.Le742 - .Lb742) / 2, 0
.Lb742:
addw r12, r0, #2047
.Le742:
.balign 4
.hword (.Le743 - .Lb743) / 2, 0
.Lb743:
addw r10, lr, #4095
.Le743:
.balign 4
.hword (.Le744 - .Lb744) / 2, 0
.Lb744:
subw r9, r10, #0
.Le744:
.balign 4
.hword (.Le745 - .Lb745) / 2, 0
.Lb745:
subw lr, lr, #1
.Le745:
.balign 4
.hword (.Le746 - .Lb746) / 2, 0
.Lb746:
subw r10, r5, #2047
.Le746:
.balign 4
.hword (.Le747 - .Lb747) / 2, 0
.Lb747:
subw lr, r10, #4095
.Le747:
.balign 4
.hword (.Le748 - .Lb748) / 2, 0
.Lb748:
movw r11, #0
.Le748:
.balign 4
.hword (.Le749 - .Lb749) / 2, 0
.Lb749:
movw r12, #1
.Le749:
.balign 4
.hword (.Le750 - .Lb750) / 2, 0
.Lb750:
movw r10, #42405
.Le750:
.balign 4
.hword (.Le751 - .Lb751) / 2, 0
.Lb751:
movw r5, #65535
.Le751:
.balign 4
.hword (.Le752 - .Lb752) / 2, 0
.Lb752:
movt r11, #0
.Le752:
.balign 4
.hword (.Le753 - .Lb753) / 2, 0
.Lb753:
movt r10, #1
.Le753:
.balign 4
.hword (.Le754 - .Lb754) / 2, 0
.Lb754:
movt r5, #42405
.Le754:
.balign 4
.hword (.Le755 - .Lb755) / 2, 0
.Lb755:
movt lr, #65535
.Le755:
.balign 4
.hword (.Le756 - .Lb756) / 2, 0
.Lb756:
adr.w r3, . + 40
.Le756:
.balign 4
.hword (.Le757 - .Lb757) / 2, 0
.Lb757:
adr r2, . + 20
.Le757:
.balign 4
.hword (.Le758 - .Lb758) / 2, 0
.Lb758:
nop
adr r2, . + 22
.Le758:
.balign 4
.hword (.Le759 - .Lb759) / 2, 0
.Lb759:
nop
adr.w r5, . + 18
.Le759:
.balign 4
.hword (.Le760 - .Lb760) / 2, 0
.Lb760:
adr.w r4, . - 20
.Le760:
.balign 4
.hword 0xffff, 0
.balign 4
group_narrow_shift:
.balign 4
.hword (.Le761 - .Lb761) / 2, 0
.Lb761:
lsls r0, r2, #1
.Le761:
.balign 4
.hword (.Le762 - .Lb762) / 2, 0
.Lb762:
lsls r0, r3, #1
.Le762:
.balign 4
.hword (.Le763 - .Lb763) / 2, 0
.Lb763:
lsls r1, r2, #1
.Le763:
.balign 4
.hword (.Le764 - .Lb764) / 2, 0
.Lb764:
lsls r1, r3, #1
.Le764:
.balign 4
.hword (.Le765 - .Lb765) / 2, 0
.Lb765:
lsls r0, r2, #7
.Le765:
.balign 4
.hword (.Le766 - .Lb766) / 2, 0
.Lb766:
lsls r0, r3, #7
.Le766:
.balign 4
.hword (.Le767 - .Lb767) / 2, 0
.Lb767:
lsls r1, r2, #7
.Le767:
.balign 4
.hword (.Le768 - .Lb768) / 2, 0
.Lb768:
lsls r1, r3, #7
.Le768:
.balign 4
.hword (.Le769 - .Lb769) / 2, 0
.Lb769:
lsls r0, r2, #31
.Le769:
.balign 4
.hword (.Le770 - .Lb770) / 2, 0
.Lb770:
lsls r0, r3, #31
.Le770:
.balign 4
.hword (.Le771 - .Lb771) / 2, 0
.Lb771:
lsls r1, r2, #31
.Le771:
.balign 4
.hword (.Le772 - .Lb772) / 2, 0
.Lb772:
lsls r1, r3, #31
.Le772:
.balign 4
.hword (.Le773 - .Lb773) / 2, 0
.Lb773:
lsrs r0, r2, #1
.Le773:
.balign 4
.hword (.Le774 - .Lb774) / 2, 0
.Lb774:
lsrs r0, r3, #1
.Le774:
.balign 4
.hword (.Le775 - .Lb775) / 2, 0
.Lb775:
lsrs r1, r2, #1
.Le775:
.balign 4
.hword (.Le776 - .Lb776) / 2, 0
.Lb776:
lsrs r1, r3, #1
.Le776:
.balign 4
.hword (.Le777 - .Lb777) / 2, 0
.Lb777:
lsrs r0, r2, #7
.Le777:
.balign 4
.hword (.Le778 - .Lb778) / 2, 0
.Lb778:
lsrs r0, r3, #7
.Le778:
.balign 4
.hword (.Le779 - .Lb779) / 2, 0
.Lb779:
lsrs r1, r2, #7
.Le779:
.balign 4
.hword (.Le780 - .Lb780) / 2, 0
.Lb780:
lsrs r1, r3, #7
.Le780:
.balign 4
.hword (.Le781 - .Lb781) / 2, 0
.Lb781:
lsrs r0, r2, #31
.Le781:
.balign 4
.hword (.Le782 - .Lb782) / 2, 0
.Lb782:
lsrs r0, r3, #31
.Le782:
.balign 4
.hword (.Le783 - .Lb783) / 2, 0
.Lb783:
lsrs r1, r2, #31
.Le783:
.balign 4
.hword (.Le784 - .Lb784) / 2, 0
.Lb784:
lsrs r1, r3, #31
.Le784:
.balign 4
.hword (.Le785 - .Lb785) / 2, 0
.Lb785:
asrs r0, r2, #1
.Le785:
.balign 4
.hword (.Le786 - .Lb786) / 2, 0
.Lb786:
asrs r0, r3, #1
.Le786:
.balign 4
.hword (.Le787 - .Lb787) / 2, 0
.Lb787:
asrs r1, r2, #1
.Le787:
.balign 4
.hword (.Le788 - .Lb788) / 2, 0
.Lb788:
asrs r1, r3, #1
.Le788:
.balign 4
.hword (.Le789 - .Lb789) / 2, 0
.Lb789:
asrs r0, r2, #7
.Le789:
.balign 4
.hword (.Le790 - .Lb790) / 2, 0
.Lb790:
asrs r0, r3, #7
.Le790:
.balign 4
.hword (.Le791 - .Lb791) / 2, 0
.Lb791:
asrs r1, r2, #7
.Le791:
.balign 4
.hword (.Le792 - .Lb792) / 2, 0
.Lb792:
asrs r1, r3, #7
.Le792:
.balign 4
.hword (.Le793 - .Lb793) / 2, 0
.Lb793:
asrs r0, r2, #31
.Le793:
.balign 4
.hword (.Le794 - .Lb794) / 2, 0
.Lb794:
asrs r0, r3, #31
.Le794:
.balign 4
.hword (.Le795 - .Lb795) / 2, 0
.Lb795:
asrs r1, r2, #31
.Le795:
.balign 4
.hword (.Le796 - .Lb796) / 2, 0
.Lb796:
asrs r1, r3, #31
.Le796:
.balign 4
.hword (.Le797 - .Lb797) / 2, 0
.Lb797:
lsrs r0, r1, #32
.Le797:
.balign 4
.hword (.Le798 - .Lb798) / 2, 0
.Lb798:
asrs r1, r2, #32
.Le798:
.balign 4
.hword (.Le799 - .Lb799) / 2, 0
.Lb799:
movs r3, r4
.Le799:
.balign 4
.hword 0xffff, 0
.balign 4
group_narrow_arithmetic:
.balign 4
.hword (.Le800 - .Lb800) / 2, 0
.Lb800:
adds r0, r1, r2
.Le800:
.balign 4
.hword (.Le801 - .Lb801) / 2, 0
.Lb801:
adds r3, r3, r4
.Le801:
.balign 4
.hword (.Le802 - .Lb802) / 2, 0
.Lb802:
adds r5, r6, r5
.Le802:
.balign 4
.hword (.Le803 - .Lb803) / 2, 0
.Lb803:
subs r0, r1, r2
.Le803:
.balign 4
.hword (.Le804 - .Lb804) / 2, 0
.Lb804:
subs r3, r3, r4
.Le804:
.balign 4
.hword (.Le805 - .Lb805) / 2, 0
.Lb805:
subs r5, r6, r5
.Le805:
.balign 4
.hword (.Le806 - .Lb806) / 2, 0
.Lb806:
adds r1, r2, #0
.Le806:
.balign 4
.hword (.Le807 - .Lb807) / 2, 0
.Lb807:
adds r1, r2, #1
.Le807:
.balign 4
.hword (.Le808 - .Lb808) / 2, 0
.Lb808:
adds r1, r2, #7
.Le808:
.balign 4
.hword (.Le809 - .Lb809) / 2, 0
.Lb809:
subs r1, r2, #0
.Le809:
.balign 4
.hword (.Le810 - .Lb810) / 2, 0
.Lb810:
subs r1, r2, #1
.Le810:
.balign 4
.hword (.Le811 - .Lb811) / 2, 0
.Lb811:
subs r1, r2, #7
.Le811:
.balign 4
.hword (.Le812 - .Lb812) / 2, 0
.Lb812:
adds r0, #0
.Le812:
.balign 4
.hword (.Le813 - .Lb813) / 2, 0
.Lb813:
adds r0, #1
.Le813:
.balign 4
.hword (.Le814 - .Lb814) / 2, 0
.Lb814:
adds r0, #128
.Le814:
.balign 4
.hword (.Le815 - .Lb815) / 2, 0
.Lb815:
adds r0, #255
.Le815:
.balign 4
.hword (.Le816 - .Lb816) / 2, 0
.Lb816:
adds r5, #0
.Le816:
.balign 4
.hword (.Le817 - .Lb817) / 2, 0
.Lb817:
adds r5, #1
.Le817:
.balign 4
.hword (.Le818 - .Lb818) / 2, 0
.Lb818:
adds r5, #128
.Le818:
.balign 4
.hword (.Le819 - .Lb819) / 2, 0
.Lb819:
adds r5, #255
.Le819:
.balign 4
.hword (.Le820 - .Lb820) / 2, 0
.Lb820:
subs r0, #0
.Le820:
.balign 4
.hword (.Le821 - .Lb821) / 2, 0
.Lb821:
subs r0, #1
.Le821:
.balign 4
.hword (.Le822 - .Lb822) / 2, 0
.Lb822:
subs r0, #128
.Le822:
.balign 4
.hword (.Le823 - .Lb823) / 2, 0
.Lb823:
subs r0, #255
.Le823:
.balign 4
.hword (.Le824 - .Lb824) / 2, 0
.Lb824:
subs r5, #0
.Le824:
.balign 4
.hword (.Le825 - .Lb825) / 2, 0
.Lb825:
subs r5, #1
.Le825:
.balign 4
.hword (.Le826 - .Lb826) / 2, 0
.Lb826:
subs r5, #128
.Le826:
.balign 4
.hword (.Le827 - .Lb827) / 2, 0
.Lb827:
subs r5, #255
.Le827:
.balign 4
.hword (.Le828 - .Lb828) / 2, 0
.Lb828:
movs r0, #0
.Le828:
.balign 4
.hword (.Le829 - .Lb829) / 2, 0
.Lb829:
movs r0, #1
.Le829:
.balign 4
.hword (.Le830 - .Lb830) / 2, 0
.Lb830:
movs r0, #128
.Le830:
.balign 4
.hword (.Le831 - .Lb831) / 2, 0
.Lb831:
movs r0, #255
.Le831:
.balign 4
.hword (.Le832 - .Lb832) / 2, 0
.Lb832:
movs r5, #0
.Le832:
.balign 4
.hword (.Le833 - .Lb833) / 2, 0
.Lb833:
movs r5, #1
.Le833:
.balign 4
.hword (.Le834 - .Lb834) / 2, 0
.Lb834:
movs r5, #128
.Le834:
.balign 4
.hword (.Le835 - .Lb835) / 2, 0
.Lb835:
movs r5, #255
.Le835:
.balign 4
.hword (.Le836 - .Lb836) / 2, 0
.Lb836:
cmp r0, #0
.Le836:
.balign 4
.hword (.Le837 - .Lb837) / 2, 0
.Lb837:
cmp r0, #1
.Le837:
.balign 4
.hword (.Le838 - .Lb838) / 2, 0
.Lb838:
cmp r0, #128
.Le838:
.balign 4
.hword (.Le839 - .Lb839) / 2, 0
.Lb839:
cmp r0, #255
.Le839:
.balign 4
.hword (.Le840 - .Lb840) / 2, 0
.Lb840:
cmp r5, #0
.Le840:
.balign 4
.hword (.Le841 - .Lb841) / 2, 0
.Lb841:
cmp r5, #1
.Le841:
.balign 4
.hword (.Le842 - .Lb842) / 2, 0
.Lb842:
cmp r5, #128
.Le842:
.balign 4
.hword (.Le843 - .Lb843) / 2, 0
.Lb843:
cmp r5, #255
.Le843:
.balign 4
.hword 0xffff, 0
.balign 4
group_narrow_data:
.balign 4
.hword (.Le844 - .Lb844) / 2, 0
.Lb844:
ands r0, r1
.Le844:
.balign 4
.hword (.Le845 - .Lb845) / 2, 0
.Lb845:
ands r4, r2
.Le845:
.balign 4
.hword (.Le846 - .Lb846) / 2, 0
.Lb846:
ands r3, r3
.Le846:
.balign 4
.hword (.Le847 - .Lb847) / 2, 0
.Lb847:
eors r0, r1
.Le847:
.balign 4
.hword (.Le848 - .Lb848) / 2, 0
.Lb848:
eors r4, r2
.Le848:
.balign 4
.hword (.Le849 - .Lb849) / 2, 0
.Lb849:
eors r3, r3
.Le849:
.balign 4
.hword (.Le850 - .Lb850) / 2, 0
.Lb850:
lsls r0, r1
.Le850:
.balign 4
.hword (.Le851 - .Lb851) / 2, 0
.Lb851:
lsls r4, r2
.Le851:
.balign 4
.hword (.Le852 - .Lb852) / 2, 0
.Lb852:
lsls r3, r3
.Le852:
.balign 4
.hword (.Le853 - .Lb853) / 2, 0
.Lb853:
lsrs r0, r1
.Le853:
.balign 4
.hword (.Le854 - .Lb854) / 2, 0
.Lb854:
lsrs r4, r2
.Le854:
.balign 4
.hword (.Le855 - .Lb855) / 2, 0
.Lb855:
lsrs r3, r3
.Le855:
.balign 4
.hword (.Le856 - .Lb856) / 2, 0
.Lb856:
asrs r0, r1
.Le856:
.balign 4
.hword (.Le857 - .Lb857) / 2, 0
.Lb857:
asrs r4, r2
.Le857:
.balign 4
.hword (.Le858 - .Lb858) / 2, 0
.Lb858:
asrs r3, r3
.Le858:
.balign 4
.hword (.Le859 - .Lb859) / 2, 0
.Lb859:
adcs r0, r1
.Le859:
.balign 4
.hword (.Le860 - .Lb860) / 2, 0
.Lb860:
adcs r4, r2
.Le860:
.balign 4
.hword (.Le861 - .Lb861) / 2, 0
.Lb861:
adcs r3, r3
.Le861:
.balign 4
.hword (.Le862 - .Lb862) / 2, 0
.Lb862:
sbcs r0, r1
.Le862:
.balign 4
.hword (.Le863 - .Lb863) / 2, 0
.Lb863:
sbcs r4, r2
.Le863:
.balign 4
.hword (.Le864 - .Lb864) / 2, 0
.Lb864:
sbcs r3, r3
.Le864:
.balign 4
.hword (.Le865 - .Lb865) / 2, 0
.Lb865:
rors r0, r1
.Le865:
.balign 4
.hword (.Le866 - .Lb866) / 2, 0
.Lb866:
rors r4, r2
.Le866:
.balign 4
.hword (.Le867 - .Lb867) / 2, 0
.Lb867:
rors r3, r3
.Le867:
.balign 4
.hword (.Le868 - .Lb868) / 2, 0
.Lb868:
tst r0, r1
.Le868:
.balign 4
.hword (.Le869 - .Lb869) / 2, 0
.Lb869:
tst r4, r2
.Le869:
.balign 4
.hword (.Le870 - .Lb870) / 2, 0
.Lb870:
tst r3, r3
.Le870:
.balign 4
.hword (.Le871 - .Lb871) / 2, 0
.Lb871:
cmp r0, r1
.Le871:
.balign 4
.hword (.Le872 - .Lb872) / 2, 0
.Lb872:
cmp r4, r2
.Le872:
.balign 4
.hword (.Le873 - .Lb873) / 2, 0
.Lb873:
cmp r3, r3
.Le873:
.balign 4
.hword (.Le874 - .Lb874) / 2, 0
.Lb874:
cmn r0, r1
.Le874:
.balign 4
.hword (.Le875 - .Lb875) / 2, 0
.Lb875:
cmn r4, r2
.Le875:
.balign 4
.hword (.Le876 - .Lb876) / 2, 0
.Lb876:
cmn r3, r3
.Le876:
.balign 4
.hword (.Le877 - .Lb877) / 2, 0
.Lb877:
orrs r0, r1
.Le877:
.balign 4
.hword (.Le878 - .Lb878) / 2, 0
.Lb878:
orrs r4, r2
.Le878:
.balign 4
.hword (.Le879 - .Lb879) / 2, 0
.Lb879:
orrs r3, r3
.Le879:
.balign 4
.hword (.Le880 - .Lb880) / 2, 0
.Lb880:
bics r0, r1
.Le880:
.balign 4
.hword (.Le881 - .Lb881) / 2, 0
.Lb881:
bics r4, r2
.Le881:
.balign 4
.hword (.Le882 - .Lb882) / 2, 0
.Lb882:
bics r3, r3
.Le882:
.balign 4
.hword (.Le883 - .Lb883) / 2, 0
.Lb883:
mvns r0, r1
.Le883:
.balign 4
.hword (.Le884 - .Lb884) / 2, 0
.Lb884:
mvns r4, r2
.Le884:
.balign 4
.hword (.Le885 - .Lb885) / 2, 0
.Lb885:
mvns r3, r3
.Le885:
.balign 4
.hword (.Le886 - .Lb886) / 2, 0
.Lb886:
rsbs r0, r1, #0
.Le886:
.balign 4
.hword (.Le887 - .Lb887) / 2, 0
.Lb887:
rsbs r2, r2, #0
.Le887:
.balign 4
.hword (.Le888 - .Lb888) / 2, 0
.Lb888:
muls r0, r1, r0
.Le888:
.balign 4
.hword (.Le889 - .Lb889) / 2, 0
.Lb889:
muls r3, r4, r3
.Le889:
.balign 4
.hword 0xffff, 0
.balign 4
group_narrow_special:
.balign 4
.hword (.Le890 - .Lb890) / 2, 0
.Lb890:
add r0, r9
.Le890:
.balign 4
.hword (.Le891 - .Lb891) / 2, 0
.Lb891:
add r10, r3
.Le891:
.balign 4
.hword (.Le892 - .Lb892) / 2, 0
.Lb892:
add r12, lr
.Le892:
.balign 4
.hword (.Le893 - .Lb893) / 2, 0
.Lb893:
cmp r0, r9
.Le893:
.balign 4
.hword (.Le894 - .Lb894) / 2, 0
.Lb894:
cmp r11, r2
.Le894:
.balign 4
.hword (.Le895 - .Lb895) / 2, 0
.Lb895:
cmp r12, r9
.Le895:
.balign 4
.hword (.Le896 - .Lb896) / 2, 0
.Lb896:
mov r0, r12
.Le896:
.balign 4
.hword (.Le897 - .Lb897) / 2, 0
.Lb897:
mov r9, r3
.Le897:
.balign 4
.hword (.Le898 - .Lb898) / 2, 0
.Lb898:
add r1, sp, #0
.Le898:
.balign 4
.hword (.Le899 - .Lb899) / 2, 0
.Lb899:
mov r2, sp
.Le899:
.balign 4
.hword (.Le900 - .Lb900) / 2, 0
.Lb900:
add r3, sp
.Le900:
.balign 4
.hword (.Le901 - .Lb901) / 2, 0
.Lb901:
add sp, #16
sub sp, #16
.Le901:
.balign 4
.hword (.Le902 - .Lb902) / 2, 0
.Lb902:
add r4, pc
.Le902:
.balign 4
.hword (.Le903 - .Lb903) / 2, 0
.Lb903:
mov r6, pc
.Le903:
.balign 4
.hword (.Le904 - .Lb904) / 2, 0
.Lb904:
nop
.Le904:
.balign 4
.hword 0xffff, 0
.balign 4
group_uxtb:
.balign 4
.hword (.Le905 - .Lb905) / 2, 0
.Lb905:
uxtb r0, r1
.Le905:
.balign 4
.hword (.Le906 - .Lb906) / 2, 0
.Lb906:
uxtb r4, r3
.Le906:
.balign 4
.hword (.Le907 - .Lb907) / 2, 0
.Lb907:
uxtb.w r11, r0, ror #0
.Le907:
.balign 4
.hword (.Le908 - .Lb908) / 2, 0
.Lb908:
uxtb.w r9, r3, ror #8
.Le908:
.balign 4
.hword (.Le909 - .Lb909) / 2, 0
.Lb909:
uxtb.w lr, r0, ror #16
.Le909:
.balign 4
.hword (.Le910 - .Lb910) / 2, 0
.Lb910:
uxtb.w r10, r12, ror #24
.Le910:
.balign 4
.hword 0xffff, 0
.balign 4
group_uxth:
.balign 4
.hword (.Le911 - .Lb911) / 2, 0
.Lb911:
uxth r0, r1
.Le911:
.balign 4
.hword (.Le912 - .Lb912) / 2, 0
.Lb912:
uxth r4, r3
.Le912:
.balign 4
.hword (.Le913 - .Lb913) / 2, 0
.Lb913:
uxth.w r3, r11, ror #0
.Le913:
.balign 4
.hword (.Le914 - .Lb914) / 2, 0
.Lb914:
uxth.w lr, lr, ror #8
.Le914:
.balign 4
.hword (.Le915 - .Lb915) / 2, 0
.Lb915:
uxth.w r11, r9, ror #16
.Le915:
.balign 4
.hword (.Le916 - .Lb916) / 2, 0
.Lb916:
uxth.w r5, r3, ror #24
.Le916:
.balign 4
.hword 0xffff, 0
.balign 4
group_sxtb:
.balign 4
.hword (.Le917 - .Lb917) / 2, 0
.Lb917:
sxtb r0, r1
.Le917:
.balign 4
.hword (.Le918 - .Lb918) / 2, 0
.Lb918:
sxtb r4, r3
.Le918:
.balign 4
.hword (.Le919 - .Lb919) / 2, 0
.Lb919:
sxtb.w r0, r10, ror #0
.Le919:
.balign 4
.hword (.Le920 - .Lb920) / 2, 0
.Lb920:
sxtb.w r9, r5, ror #8
.Le920:
.balign 4
.hword (.Le921 - .Lb921) / 2, 0
.Lb921:
sxtb.w r9, r3, ror #16
.Le921:
.balign 4
.hword (.Le922 - .Lb922) / 2, 0
.Lb922:
sxtb.w r11, r10, ror #24
.Le922:
.balign 4
.hword 0xffff, 0
.balign 4
group_sxth:
.balign 4
.hword (.Le923 - .Lb923) / 2, 0
.Lb923:
sxth r0, r1
.Le923:
.balign 4
.hword (.Le924 - .Lb924) / 2, 0
.Lb924:
sxth r4, r3
.Le924:
.balign 4
.hword (.Le925 - .Lb925) / 2, 0
.Lb925:
sxth.w r5, r9, ror #0
.Le925:
.balign 4
.hword (.Le926 - .Lb926) / 2, 0
.Lb926:
sxth.w r3, r0, ror #8
.Le926:
.balign 4
.hword (.Le927 - .Lb927) / 2, 0
.Lb927:
sxth.w r0, r10, ror #16
.Le927:
.balign 4
.hword (.Le928 - .Lb928) / 2, 0
.Lb928:
sxth.w lr, r12, ror #24
.Le928:
.balign 4
.hword 0xffff, 0
.balign 4
group_uxtb16:
.balign 4
.hword (.Le929 - .Lb929) / 2, 0
.Lb929:
uxtb16 r3, r9, ror #0
.Le929:
.balign 4
.hword (.Le930 - .Lb930) / 2, 0
.Lb930:
uxtb16 r0, r12, ror #8
.Le930:
.balign 4
.hword (.Le931 - .Lb931) / 2, 0
.Lb931:
uxtb16 r11, r5, ror #16
.Le931:
.balign 4
.hword (.Le932 - .Lb932) / 2, 0
.Lb932:
uxtb16 r5, r9, ror #24
.Le932:
.balign 4
.hword 0xffff, 0
.balign 4
group_sxtb16:
.balign 4
.hword (.Le933 - .Lb933) / 2, 0
.Lb933:
sxtb16 r0, r3, ror #0
.Le933:
.balign 4
.hword (.Le934 - .Lb934) / 2, 0
.Lb934:
sxtb16 lr, r9, ror #8
.Le934:
.balign 4
.hword (.Le935 - .Lb935) / 2, 0
.Lb935:
sxtb16 r9, r5, ror #16
.Le935:
.balign 4
.hword (.Le936 - .Lb936) / 2, 0
.Lb936:
sxtb16 r12, lr, ror #24
.Le936:
.balign 4
.hword 0xffff, 0
.balign 4
group_uxtab:
.balign 4
.hword (.Le937 - .Lb937) / 2, 0
.Lb937:
uxtab r0, lr, r10, ror #0
.Le937:
.balign 4
.hword (.Le938 - .Lb938) / 2, 0
.Lb938:
uxtab r10, r10, r9, ror #0
.Le938:
.balign 4
.hword (.Le939 - .Lb939) / 2, 0
.Lb939:
uxtab r5, r12, r0, ror #8
.Le939:
.balign 4
.hword (.Le940 - .Lb940) / 2, 0
.Lb940:
uxtab r12, lr, r0, ror #8
.Le940:
.balign 4
.hword (.Le941 - .Lb941) / 2, 0
.Lb941:
uxtab r5, r9, lr, ror #16
.Le941:
.balign 4
.hword (.Le942 - .Lb942) / 2, 0
.Lb942:
uxtab r3, r10, r12, ror #16
.Le942:
.balign 4
.hword (.Le943 - .Lb943) / 2, 0
.Lb943:
uxtab r9, r11, r3, ror #24
.Le943:
.balign 4
.hword (.Le944 - .Lb944) / 2, 0
.Lb944:
uxtab r9, r9, lr, ror #24
.Le944:
.balign 4
.hword 0xffff, 0
.balign 4
group_uxtah:
.balign 4
.hword (.Le945 - .Lb945) / 2, 0
.Lb945:
uxtah r3, r5, lr, ror #0
.Le945:
.balign 4
.hword (.Le946 - .Lb946) / 2, 0
.Lb946:
uxtah r11, r12, r12, ror #0
.Le946:
.balign 4
.hword (.Le947 - .Lb947) / 2, 0
.Lb947:
uxtah r12, r0, r12, ror #8
.Le947:
.balign 4
.hword (.Le948 - .Lb948) / 2, 0
.Lb948:
uxtah r5, r12, r5, ror #8
.Le948:
.balign 4
.hword (.Le949 - .Lb949) / 2, 0
.Lb949:
uxtah r0, r10, r12, ror #16
.Le949:
.balign 4
.hword (.Le950 - .Lb950) / 2, 0
.Lb950:
uxtah r12, r3, r9, ror #16
.Le950:
.balign 4
.hword (.Le951 - .Lb951) / 2, 0
.Lb951:
uxtah r10, lr, r12, ror #24
.Le951:
.balign 4
.hword (.Le952 - .Lb952) / 2, 0
.Lb952:
uxtah r10, r3, r11, ror #24
.Le952:
.balign 4
.hword 0xffff, 0
.balign 4
group_sxtab:
.balign 4
.hword (.Le953 - .Lb953) / 2, 0
.Lb953:
sxtab r5, r10, r0, ror #0
.Le953:
.balign 4
.hword (.Le954 - .Lb954) / 2, 0
.Lb954:
sxtab r3, r11, lr, ror #0
.Le954:
.balign 4
.hword (.Le955 - .Lb955) / 2, 0
.Lb955:
sxtab r10, r3, r10, ror #8
.Le955:
.balign 4
.hword (.Le956 - .Lb956) / 2, 0
.Lb956:
sxtab r5, r3, r12, ror #8
.Le956:
.balign 4
.hword (.Le957 - .Lb957) / 2, 0
.Lb957:
sxtab r12, r0, lr, ror #16
.Le957:
.balign 4
.hword (.Le958 - .Lb958) / 2, 0
.Lb958:
sxtab r5, r12, lr, ror #16
.Le958:
.balign 4
.hword (.Le959 - .Lb959) / 2, 0
.Lb959:
sxtab r9, r0, r12, ror #24
.Le959:
.balign 4
.hword (.Le960 - .Lb960) / 2, 0
.Lb960:
sxtab r0, r12, r3, ror #24
.Le960:
.balign 4
.hword 0xffff, 0
.balign 4
group_sxtah:
.balign 4
.hword (.Le961 - .Lb961) / 2, 0
.Lb961:
sxtah r9, r0, lr, ror #0
.Le961:
.balign 4
.hword (.Le962 - .Lb962) / 2, 0
.Lb962:
sxtah r3, r10, r0, ror #0
.Le962:
.balign 4
.hword (.Le963 - .Lb963) / 2, 0
.Lb963:
sxtah r11, r0, r3, ror #8
.Le963:
.balign 4
.hword (.Le964 - .Lb964) / 2, 0
.Lb964:
sxtah r3, r0, r10, ror #8
.Le964:
.balign 4
.hword (.Le965 - .Lb965) / 2, 0
.Lb965:
sxtah r11, r10, r3, ror #16
.Le965:
.balign 4
.hword (.Le966 - .Lb966) / 2, 0
.Lb966:
sxtah lr, r11, r11, ror #16
.Le966:
.balign 4
.hword (.Le967 - .Lb967) / 2, 0
.Lb967:
sxtah r5, r11, r9, ror #24
.Le967:
.balign 4
.hword (.Le968 - .Lb968) / 2, 0
.Lb968:
sxtah r11, r9, r9, ror #24
.Le968:
.balign 4
.hword 0xffff, 0
.balign 4
group_uxtab16:
.balign 4
.hword (.Le969 - .Lb969) / 2, 0
.Lb969:
uxtab16 r9, r10, r10, ror #0
.Le969:
.balign 4
.hword (.Le970 - .Lb970) / 2, 0
.Lb970:
uxtab16 r11, r10, r0, ror #0
.Le970:
.balign 4
.hword (.Le971 - .Lb971) / 2, 0
.Lb971:
uxtab16 lr, r10, r9, ror #8
.Le971:
.balign 4
.hword (.Le972 - .Lb972) / 2, 0
.Lb972:
uxtab16 r5, r9, r5, ror #8
.Le972:
.balign 4
.hword (.Le973 - .Lb973) / 2, 0
.Lb973:
uxtab16 r3, r10, r12, ror #16
.Le973:
.balign 4
.hword (.Le974 - .Lb974) / 2, 0
.Lb974:
uxtab16 r9, r5, r5, ror #16
.Le974:
.balign 4
.hword (.Le975 - .Lb975) / 2, 0
.Lb975:
uxtab16 r3, r11, r12, ror #24
.Le975:
.balign 4
.hword (.Le976 - .Lb976) / 2, 0
.Lb976:
uxtab16 r9, r5, r0, ror #24
.Le976:
.balign 4
.hword 0xffff, 0
.balign 4
group_sxtab16:
.balign 4
.hword (.Le977 - .Lb977) / 2, 0
.Lb977:
sxtab16 lr, r9, r12, ror #0
.Le977:
.balign 4
.hword (.Le978 - .Lb978) / 2, 0
.Lb978:
sxtab16 r3, r10, r9, ror #0
.Le978:
.balign 4
.hword (.Le979 - .Lb979) / 2, 0
.Lb979:
sxtab16 r10, lr, r11, ror #8
.Le979:
.balign 4
.hword (.Le980 - .Lb980) / 2, 0
.Lb980:
sxtab16 r3, r3, r3, ror #8
.Le980:
.balign 4
.hword (.Le981 - .Lb981) / 2, 0
.Lb981:
sxtab16 r9, r3, lr, ror #16
.Le981:
.balign 4
.hword (.Le982 - .Lb982) / 2, 0
.Lb982:
sxtab16 lr, r0, r5, ror #16
.Le982:
.balign 4
.hword (.Le983 - .Lb983) / 2, 0
.Lb983:
sxtab16 lr, r12, r3, ror #24
.Le983:
.balign 4
.hword (.Le984 - .Lb984) / 2, 0
.Lb984:
sxtab16 r9, r0, r9, ror #24
.Le984:
.balign 4
.hword 0xffff, 0
.balign 4
group_bitfield:
.balign 4
.hword (.Le985 - .Lb985) / 2, 0
.Lb985:
ubfx r10, r9, #0, #1
.Le985:
.balign 4
.hword (.Le986 - .Lb986) / 2, 0
.Lb986:
ubfx r10, r10, #0, #32
.Le986:
.balign 4
.hword (.Le987 - .Lb987) / 2, 0
.Lb987:
ubfx r10, r10, #31, #1
.Le987:
.balign 4
.hword (.Le988 - .Lb988) / 2, 0
.Lb988:
ubfx r0, r0, #5, #7
.Le988:
.balign 4
.hword (.Le989 - .Lb989) / 2, 0
.Lb989:
ubfx r0, r9, #16, #16
.Le989:
.balign 4
.hword (.Le990 - .Lb990) / 2, 0
.Lb990:
ubfx r11, lr, #1, #31
.Le990:
.balign 4
.hword (.Le991 - .Lb991) / 2, 0
.Lb991:
ubfx r3, r9, #24, #8
.Le991:
.balign 4
.hword (.Le992 - .Lb992) / 2, 0
.Lb992:
ubfx r9, r0, #3, #20
.Le992:
.balign 4
.hword (.Le993 - .Lb993) / 2, 0
.Lb993:
sbfx r5, r0, #0, #1
.Le993:
.balign 4
.hword (.Le994 - .Lb994) / 2, 0
.Lb994:
sbfx r0, r9, #0, #32
.Le994:
.balign 4
.hword (.Le995 - .Lb995) / 2, 0
.Lb995:
sbfx r5, r0, #31, #1
.Le995:
.balign 4
.hword (.Le996 - .Lb996) / 2, 0
.Lb996:
sbfx r5, r3, #5, #7
.Le996:
.balign 4
.hword (.Le997 - .Lb997) / 2, 0
.Lb997:
sbfx r5, r11, #16, #16
.Le997:
.balign 4
.hword (.Le998 - .Lb998) / 2, 0
.Lb998:
sbfx r10, r9, #1, #31
.Le998:
.balign 4
.hword (.Le999 - .Lb999) / 2, 0
.Lb999:
sbfx r0, r10, #24, #8
.Le999:
.balign 4
.hword (.Le1000 - .Lb1000) / 2, 0
.Lb1000:
sbfx r10, r12, #3, #20
.Le1000:
.balign 4
.hword (.Le1001 - .Lb1001) / 2, 0
.Lb1001:
bfi lr, r10, #0, #1
.Le1001:
.balign 4
.hword (.Le1002 - .Lb1002) / 2, 0
.Lb1002:
bfi r5, lr, #0, #32
.Le1002:
.balign 4
.hword (.Le1003 - .Lb1003) / 2, 0
.Lb1003:
bfi r5, r9, #31, #1
.Le1003:
.balign 4
.hword (.Le1004 - .Lb1004) / 2, 0
.Lb1004:
bfi r0, r11, #5, #7
.Le1004:
.balign 4
.hword (.Le1005 - .Lb1005) / 2, 0
.Lb1005:
bfi r9, r11, #16, #16
.Le1005:
.balign 4
.hword (.Le1006 - .Lb1006) / 2, 0
.Lb1006:
bfi r0, r12, #1, #31
.Le1006:
.balign 4
.hword (.Le1007 - .Lb1007) / 2, 0
.Lb1007:
bfi r3, r0, #24, #8
.Le1007:
.balign 4
.hword (.Le1008 - .Lb1008) / 2, 0
.Lb1008:
bfi r12, r12, #3, #20
.Le1008:
.balign 4
.hword (.Le1009 - .Lb1009) / 2, 0
.Lb1009:
bfc r0, #0, #1
.Le1009:
.balign 4
.hword (.Le1010 - .Lb1010) / 2, 0
.Lb1010:
bfc r10, #0, #32
.Le1010:
.balign 4
.hword (.Le1011 - .Lb1011) / 2, 0
.Lb1011:
bfc r0, #31, #1
.Le1011:
.balign 4
.hword (.Le1012 - .Lb1012) / 2, 0
.Lb1012:
bfc r5, #5, #7
.Le1012:
.balign 4
.hword (.Le1013 - .Lb1013) / 2, 0
.Lb1013:
bfc r9, #16, #16
.Le1013:
.balign 4
.hword (.Le1014 - .Lb1014) / 2, 0
.Lb1014:
bfc r0, #1, #31
.Le1014:
.balign 4
.hword (.Le1015 - .Lb1015) / 2, 0
.Lb1015:
bfc r0, #24, #8
.Le1015:
.balign 4
.hword (.Le1016 - .Lb1016) / 2, 0
.Lb1016:
bfc r0, #3, #20
.Le1016:
.balign 4
.hword 0xffff, 0
.balign 4
group_count_reverse:
.balign 4
.hword (.Le1017 - .Lb1017) / 2, 0
.Lb1017:
clz r5, lr
.Le1017:
.balign 4
.hword (.Le1018 - .Lb1018) / 2, 0
.Lb1018:
clz r3, r9
.Le1018:
.balign 4
.hword (.Le1019 - .Lb1019) / 2, 0
.Lb1019:
rbit r3, r11
.Le1019:
.balign 4
.hword (.Le1020 - .Lb1020) / 2, 0
.Lb1020:
rbit lr, r11
.Le1020:
.balign 4
.hword (.Le1021 - .Lb1021) / 2, 0
.Lb1021:
rev.w r12, lr
.Le1021:
.balign 4
.hword (.Le1022 - .Lb1022) / 2, 0
.Lb1022:
rev.w r10, r11
.Le1022:
.balign 4
.hword (.Le1023 - .Lb1023) / 2, 0
.Lb1023:
rev16.w r12, r12
.Le1023:
.balign 4
.hword (.Le1024 - .Lb1024) / 2, 0
.Lb1024:
rev16.w r3, r11
.Le1024:
.balign 4
.hword (.Le1025 - .Lb1025) / 2, 0
.Lb1025:
revsh.w r3, r12
.Le1025:
.balign 4
.hword (.Le1026 - .Lb1026) / 2, 0
.Lb1026:
revsh.w lr, lr
.Le1026:
.balign 4
.hword (.Le1027 - .Lb1027) / 2, 0
.Lb1027:
rev r0, r1
.Le1027:
.balign 4
.hword (.Le1028 - .Lb1028) / 2, 0
.Lb1028:
rev r4, r2
.Le1028:
.balign 4
.hword (.Le1029 - .Lb1029) / 2, 0
.Lb1029:
rev16 r0, r1
.Le1029:
.balign 4
.hword (.Le1030 - .Lb1030) / 2, 0
.Lb1030:
rev16 r4, r2
.Le1030:
.balign 4
.hword (.Le1031 - .Lb1031) / 2, 0
.Lb1031:
revsh r0, r1
.Le1031:
.balign 4
.hword (.Le1032 - .Lb1032) / 2, 0
.Lb1032:
revsh r4, r2
.Le1032:
.balign 4
.hword 0xffff, 0
.balign 4
group_sel:
.balign 4
.hword (.Le1033 - .Lb1033) / 2, 0
.Lb1033:
sel r3, r9, lr
.Le1033:
.balign 4
.hword (.Le1034 - .Lb1034) / 2, 0
.Lb1034:
sel r11, r3, r11
.Le1034:
.balign 4
.hword (.Le1035 - .Lb1035) / 2, 0
.Lb1035:
sel r0, r10, r11
.Le1035:
.balign 4
.hword (.Le1036 - .Lb1036) / 2, 0
.Lb1036:
sel r5, r5, r12
.Le1036:
.balign 4
.hword (.Le1037 - .Lb1037) / 2, 0
.Lb1037:
sel r10, lr, r9
.Le1037:
.balign 4
.hword (.Le1038 - .Lb1038) / 2, 0
.Lb1038:
sel lr, r12, r0
.Le1038:
.balign 4
.hword 0xffff, 0
.balign 4
group_ssat:
.balign 4
.hword (.Le1039 - .Lb1039) / 2, 0
.Lb1039:
ssat r10, #1, r3
.Le1039:
.balign 4
.hword (.Le1040 - .Lb1040) / 2, 0
.Lb1040:
ssat r10, #1, r0, lsl #1
.Le1040:
.balign 4
.hword (.Le1041 - .Lb1041) / 2, 0
.Lb1041:
ssat r11, #1, r5, lsl #31
.Le1041:
.balign 4
.hword (.Le1042 - .Lb1042) / 2, 0
.Lb1042:
ssat r10, #1, r3, asr #1
.Le1042:
.balign 4
.hword (.Le1043 - .Lb1043) / 2, 0
.Lb1043:
ssat lr, #1, r11, asr #31
.Le1043:
.balign 4
.hword (.Le1044 - .Lb1044) / 2, 0
.Lb1044:
ssat lr, #2, lr
.Le1044:
.balign 4
.hword (.Le1045 - .Lb1045) / 2, 0
.Lb1045:
ssat lr, #2, r3, lsl #1
.Le1045:
.balign 4
.hword (.Le1046 - .Lb1046) / 2, 0
.Lb1046:
ssat r0, #2, r0, lsl #31
.Le1046:
.balign 4
.hword (.Le1047 - .Lb1047) / 2, 0
.Lb1047:
ssat r0, #2, r10, asr #1
.Le1047:
.balign 4
.hword (.Le1048 - .Lb1048) / 2, 0
.Lb1048:
ssat r5, #2, lr, asr #31
.Le1048:
.balign 4
.hword (.Le1049 - .Lb1049) / 2, 0
.Lb1049:
ssat r0, #8, lr
.Le1049:
.balign 4
.hword (.Le1050 - .Lb1050) / 2, 0
.Lb1050:
ssat r9, #8, r9, lsl #1
.Le1050:
.balign 4
.hword (.Le1051 - .Lb1051) / 2, 0
.Lb1051:
ssat r0, #8, r0, lsl #31
.Le1051:
.balign 4
.hword (.Le1052 - .Lb1052) / 2, 0
.Lb1052:
ssat r9, #8, r12, asr #1
.Le1052:
.balign 4
.hword (.Le1053 - .Lb1053) / 2, 0
.Lb1053:
ssat r5, #8, r9, asr #31
.Le1053:
.balign 4
.hword (.Le1054 - .Lb1054) / 2, 0
.Lb1054:
ssat r12, #16, r0
.Le1054:
.balign 4
.hword (.Le1055 - .Lb1055) / 2, 0
.Lb1055:
ssat r11, #16, r0, lsl #1
.Le1055:
.balign 4
.hword (.Le1056 - .Lb1056) / 2, 0
.Lb1056:
ssat r5, #16, r0, lsl #31
.Le1056:
.balign 4
.hword (.Le1057 - .Lb1057) / 2, 0
.Lb1057:
ssat r9, #16, r10, asr #1
.Le1057:
.balign 4
.hword (.Le1058 - .Lb1058) / 2, 0
.Lb1058:
ssat r9, #16, r0, asr #31
.Le1058:
.balign 4
.hword (.Le1059 - .Lb1059) / 2, 0
.Lb1059:
ssat r12, #31, r12
.Le1059:
.balign 4
.hword (.Le1060 - .Lb1060) / 2, 0
.Lb1060:
ssat r10, #31, lr, lsl #1
.Le1060:
.balign 4
.hword (.Le1061 - .Lb1061) / 2, 0
.Lb1061:
ssat r0, #31, r3, lsl #31
.Le1061:
.balign 4
.hword (.Le1062 - .Lb1062) / 2, 0
.Lb1062:
ssat r12, #31, r5, asr #1
.Le1062:
.balign 4
.hword (.Le1063 - .Lb1063) / 2, 0
.Lb1063:
ssat r5, #31, r5, asr #31
.Le1063:
.balign 4
.hword (.Le1064 - .Lb1064) / 2, 0
.Lb1064:
ssat r12, #32, lr
.Le1064:
.balign 4
.hword (.Le1065 - .Lb1065) / 2, 0
.Lb1065:
ssat r11, #32, lr, lsl #1
.Le1065:
.balign 4
.hword (.Le1066 - .Lb1066) / 2, 0
.Lb1066:
ssat r12, #32, r10, lsl #31
.Le1066:
.balign 4
.hword (.Le1067 - .Lb1067) / 2, 0
.Lb1067:
ssat r11, #32, r9, asr #1
.Le1067:
.balign 4
.hword (.Le1068 - .Lb1068) / 2, 0
.Lb1068:
ssat r0, #32, r3, asr #31
.Le1068:
.balign 4
.hword 0xffff, 0
.balign 4
group_usat:
.balign 4
.hword (.Le1069 - .Lb1069) / 2, 0
.Lb1069:
usat r12, #0, r5
.Le1069:
.balign 4
.hword (.Le1070 - .Lb1070) / 2, 0
.Lb1070:
usat r10, #0, lr, lsl #1
.Le1070:
.balign 4
.hword (.Le1071 - .Lb1071) / 2, 0
.Lb1071:
usat r5, #0, lr, lsl #31
.Le1071:
.balign 4
.hword (.Le1072 - .Lb1072) / 2, 0
.Lb1072:
usat r9, #0, r5, asr #1
.Le1072:
.balign 4
.hword (.Le1073 - .Lb1073) / 2, 0
.Lb1073:
usat r12, #0, r0, asr #31
.Le1073:
.balign 4
.hword (.Le1074 - .Lb1074) / 2, 0
.Lb1074:
usat r3, #1, r3
.Le1074:
.balign 4
.hword (.Le1075 - .Lb1075) / 2, 0
.Lb1075:
usat lr, #1, r0, lsl #1
.Le1075:
.balign 4
.hword (.Le1076 - .Lb1076) / 2, 0
.Lb1076:
usat r10, #1, r0, lsl #31
.Le1076:
.balign 4
.hword (.Le1077 - .Lb1077) / 2, 0
.Lb1077:
usat r9, #1, r11, asr #1
.Le1077:
.balign 4
.hword (.Le1078 - .Lb1078) / 2, 0
.Lb1078:
usat r3, #1, r11, asr #31
.Le1078:
.balign 4
.hword (.Le1079 - .Lb1079) / 2, 0
.Lb1079:
usat r12, #8, r12
.Le1079:
.balign 4
.hword (.Le1080 - .Lb1080) / 2, 0
.Lb1080:
usat r3, #8, r9, lsl #1
.Le1080:
.balign 4
.hword (.Le1081 - .Lb1081) / 2, 0
.Lb1081:
usat r11, #8, r12, lsl #31
.Le1081:
.balign 4
.hword (.Le1082 - .Lb1082) / 2, 0
.Lb1082:
usat r12, #8, r10, asr #1
.Le1082:
.balign 4
.hword (.Le1083 - .Lb1083) / 2, 0
.Lb1083:
usat r5, #8, r0, asr #31
.Le1083:
.balign 4
.hword (.Le1084 - .Lb1084) / 2, 0
.Lb1084:
usat r11, #16, r12
.Le1084:
.balign 4
.hword (.Le1085 - .Lb1085) / 2, 0
.Lb1085:
usat r11, #16, r5, lsl #1
.Le1085:
.balign 4
.hword (.Le1086 - .Lb1086) / 2, 0
.Lb1086:
usat r3, #16, r9, lsl #31
.Le1086:
.balign 4
.hword (.Le1087 - .Lb1087) / 2, 0
.Lb1087:
usat r9, #16, r11, asr #1
.Le1087:
.balign 4
.hword (.Le1088 - .Lb1088) / 2, 0
.Lb1088:
usat r9, #16, r10, asr #31
.Le1088:
.balign 4
.hword (.Le1089 - .Lb1089) / 2, 0
.Lb1089:
usat r5, #31, r12
.Le1089:
.balign 4
.hword (.Le1090 - .Lb1090) / 2, 0
.Lb1090:
usat lr, #31, r11, lsl #1
.Le1090:
.balign 4
.hword (.Le1091 - .Lb1091) / 2, 0
.Lb1091:
usat r3, #31, r0, lsl #31
.Le1091:
.balign 4
.hword (.Le1092 - .Lb1092) / 2, 0
.Lb1092:
usat r9, #31, r5, asr #1
.Le1092:
.balign 4
.hword (.Le1093 - .Lb1093) / 2, 0
.Lb1093:
usat r12, #31, lr, asr #31
.Le1093:
.balign 4
.hword 0xffff, 0
.balign 4
group_sat16:
.balign 4
.hword (.Le1094 - .Lb1094) / 2, 0
.Lb1094:
ssat16 r12, #1, r11
.Le1094:
.balign 4
.hword (.Le1095 - .Lb1095) / 2, 0
.Lb1095:
ssat16 r11, #2, r3
.Le1095:
.balign 4
.hword (.Le1096 - .Lb1096) / 2, 0
.Lb1096:
ssat16 r5, #8, lr
.Le1096:
.balign 4
.hword (.Le1097 - .Lb1097) / 2, 0
.Lb1097:
ssat16 r3, #15, r0
.Le1097:
.balign 4
.hword (.Le1098 - .Lb1098) / 2, 0
.Lb1098:
ssat16 r0, #16, r5
.Le1098:
.balign 4
.hword (.Le1099 - .Lb1099) / 2, 0
.Lb1099:
usat16 r9, #0, lr
.Le1099:
.balign 4
.hword (.Le1100 - .Lb1100) / 2, 0
.Lb1100:
usat16 r10, #1, r10
.Le1100:
.balign 4
.hword (.Le1101 - .Lb1101) / 2, 0
.Lb1101:
usat16 r3, #8, r12
.Le1101:
.balign 4
.hword (.Le1102 - .Lb1102) / 2, 0
.Lb1102:
usat16 r9, #15, r3
.Le1102:
.balign 4
.hword 0xffff, 0
.balign 4
group_pkh:
.balign 4
.hword (.Le1103 - .Lb1103) / 2, 0
.Lb1103:
pkhbt r5, r0, r12
.Le1103:
.balign 4
.hword (.Le1104 - .Lb1104) / 2, 0
.Lb1104:
pkhbt r0, r10, r11, lsl #1
.Le1104:
.balign 4
.hword (.Le1105 - .Lb1105) / 2, 0
.Lb1105:
pkhbt r0, lr, r11, lsl #16
.Le1105:
.balign 4
.hword (.Le1106 - .Lb1106) / 2, 0
.Lb1106:
pkhbt r0, r11, r12, lsl #31
.Le1106:
.balign 4
.hword (.Le1107 - .Lb1107) / 2, 0
.Lb1107:
pkhtb r0, lr, r3, asr #1
.Le1107:
.balign 4
.hword (.Le1108 - .Lb1108) / 2, 0
.Lb1108:
pkhtb r12, r12, r3, asr #16
.Le1108:
.balign 4
.hword (.Le1109 - .Lb1109) / 2, 0
.Lb1109:
pkhtb r0, r0, r12, asr #32
.Le1109:
.balign 4
.hword 0xffff, 0
.balign 4
group_qadd:
.balign 4
.hword (.Le1110 - .Lb1110) / 2, 0
.Lb1110:
qadd r11, r12, r5
.Le1110:
.balign 4
.hword (.Le1111 - .Lb1111) / 2, 0
.Lb1111:
qadd r0, r10, r5
.Le1111:
.balign 4
.hword (.Le1112 - .Lb1112) / 2, 0
.Lb1112:
qadd r12, lr, r5
.Le1112:
.balign 4
.hword (.Le1113 - .Lb1113) / 2, 0
.Lb1113:
qsub r10, r0, r10
.Le1113:
.balign 4
.hword (.Le1114 - .Lb1114) / 2, 0
.Lb1114:
qsub r12, r5, r12
.Le1114:
.balign 4
.hword (.Le1115 - .Lb1115) / 2, 0
.Lb1115:
qsub r11, lr, r5
.Le1115:
.balign 4
.hword (.Le1116 - .Lb1116) / 2, 0
.Lb1116:
qdadd r12, r3, r5
.Le1116:
.balign 4
.hword (.Le1117 - .Lb1117) / 2, 0
.Lb1117:
qdadd r12, r12, r10
.Le1117:
.balign 4
.hword (.Le1118 - .Lb1118) / 2, 0
.Lb1118:
qdadd lr, r10, r0
.Le1118:
.balign 4
.hword (.Le1119 - .Lb1119) / 2, 0
.Lb1119:
qdsub r5, r12, r10
.Le1119:
.balign 4
.hword (.Le1120 - .Lb1120) / 2, 0
.Lb1120:
qdsub r10, r10, r3
.Le1120:
.balign 4
.hword (.Le1121 - .Lb1121) / 2, 0
.Lb1121:
qdsub r0, r3, r3
.Le1121:
.balign 4
.hword 0xffff, 0
.balign 4
group_parallel_add8:
.balign 4
.hword (.Le1122 - .Lb1122) / 2, 0
.Lb1122:
sadd8 lr, r5, lr
.Le1122:
.balign 4
.hword (.Le1123 - .Lb1123) / 2, 0
.Lb1123:
sadd8 r9, r9, r0
.Le1123:
.balign 4
.hword (.Le1124 - .Lb1124) / 2, 0
.Lb1124:
qadd8 r9, r3, r3
.Le1124:
.balign 4
.hword (.Le1125 - .Lb1125) / 2, 0
.Lb1125:
qadd8 r3, r0, r3
.Le1125:
.balign 4
.hword (.Le1126 - .Lb1126) / 2, 0
.Lb1126:
shadd8 r0, r10, r12
.Le1126:
.balign 4
.hword (.Le1127 - .Lb1127) / 2, 0
.Lb1127:
shadd8 r5, r11, r3
.Le1127:
.balign 4
.hword (.Le1128 - .Lb1128) / 2, 0
.Lb1128:
uadd8 r0, r12, r9
.Le1128:
.balign 4
.hword (.Le1129 - .Lb1129) / 2, 0
.Lb1129:
uadd8 r5, lr, r5
.Le1129:
.balign 4
.hword (.Le1130 - .Lb1130) / 2, 0
.Lb1130:
uqadd8 r11, r12, r5
.Le1130:
.balign 4
.hword (.Le1131 - .Lb1131) / 2, 0
.Lb1131:
uqadd8 r11, r3, r0
.Le1131:
.balign 4
.hword (.Le1132 - .Lb1132) / 2, 0
.Lb1132:
uhadd8 r0, r10, r3
.Le1132:
.balign 4
.hword (.Le1133 - .Lb1133) / 2, 0
.Lb1133:
uhadd8 lr, r3, r0
.Le1133:
.balign 4
.hword 0xffff, 0
.balign 4
group_parallel_add16:
.balign 4
.hword (.Le1134 - .Lb1134) / 2, 0
.Lb1134:
sadd16 r0, r10, r10
.Le1134:
.balign 4
.hword (.Le1135 - .Lb1135) / 2, 0
.Lb1135:
sadd16 r10, lr, r12
.Le1135:
.balign 4
.hword (.Le1136 - .Lb1136) / 2, 0
.Lb1136:
qadd16 r3, r9, r10
.Le1136:
.balign 4
.hword (.Le1137 - .Lb1137) / 2, 0
.Lb1137:
qadd16 r5, r0, r11
.Le1137:
.balign 4
.hword (.Le1138 - .Lb1138) / 2, 0
.Lb1138:
shadd16 lr, r3, r12
.Le1138:
.balign 4
.hword (.Le1139 - .Lb1139) / 2, 0
.Lb1139:
shadd16 r5, r10, r3
.Le1139:
.balign 4
.hword (.Le1140 - .Lb1140) / 2, 0
.Lb1140:
uadd16 r11, r10, r9
.Le1140:
.balign 4
.hword (.Le1141 - .Lb1141) / 2, 0
.Lb1141:
uadd16 r11, r5, r9
.Le1141:
.balign 4
.hword (.Le1142 - .Lb1142) / 2, 0
.Lb1142:
uqadd16 r0, r9, lr
.Le1142:
.balign 4
.hword (.Le1143 - .Lb1143) / 2, 0
.Lb1143:
uqadd16 r11, r5, r12
.Le1143:
.balign 4
.hword (.Le1144 - .Lb1144) / 2, 0
.Lb1144:
uhadd16 r11, r12, lr
.Le1144:
.balign 4
.hword (.Le1145 - .Lb1145) / 2, 0
.Lb1145:
uhadd16 r3, r10, r0
.Le1145:
.balign 4
.hword 0xffff, 0
.balign 4
group_parallel_asx:
.balign 4
.hword (.Le1146 - .Lb1146) / 2, 0
.Lb1146:
sasx r10, r11, r9
.Le1146:
.balign 4
.hword (.Le1147 - .Lb1147) / 2, 0
.Lb1147:
sasx r9, r9, r9
.Le1147:
.balign 4
.hword (.Le1148 - .Lb1148) / 2, 0
.Lb1148:
qasx r12, r11, r10
.Le1148:
.balign 4
.hword (.Le1149 - .Lb1149) / 2, 0
.Lb1149:
qasx r0, lr, r5
.Le1149:
.balign 4
.hword (.Le1150 - .Lb1150) / 2, 0
.Lb1150:
shasx r12, lr, r3
.Le1150:
.balign 4
.hword (.Le1151 - .Lb1151) / 2, 0
.Lb1151:
shasx r10, r3, r9
.Le1151:
.balign 4
.hword (.Le1152 - .Lb1152) / 2, 0
.Lb1152:
uasx r3, r12, r12
.Le1152:
.balign 4
.hword (.Le1153 - .Lb1153) / 2, 0
.Lb1153:
uasx r5, r3, lr
.Le1153:
.balign 4
.hword (.Le1154 - .Lb1154) / 2, 0
.Lb1154:
uqasx r9, r5, r9
.Le1154:
.balign 4
.hword (.Le1155 - .Lb1155) / 2, 0
.Lb1155:
uqasx r10, r11, r11
.Le1155:
.balign 4
.hword (.Le1156 - .Lb1156) / 2, 0
.Lb1156:
uhasx r11, r10, r5
.Le1156:
.balign 4
.hword (.Le1157 - .Lb1157) / 2, 0
.Lb1157:
uhasx r0, r9, r10
.Le1157:
.balign 4
.hword 0xffff, 0
.balign 4
group_parallel_sax:
.balign 4
.hword (.Le1158 - .Lb1158) / 2, 0
.Lb1158:
ssax lr, r0, r11
.Le1158:
.balign 4
.hword (.Le1159 - .Lb1159) / 2, 0
.Lb1159:
ssax r0, r5, r9
.Le1159:
.balign 4
.hword (.Le1160 - .Lb1160) / 2, 0
.Lb1160:
qsax r10, r9, r3
.Le1160:
.balign 4
.hword (.Le1161 - .Lb1161) / 2, 0
.Lb1161:
qsax r12, r11, r11
.Le1161:
.balign 4
.hword (.Le1162 - .Lb1162) / 2, 0
.Lb1162:
shsax r9, r3, r0
.Le1162:
.balign 4
.hword (.Le1163 - .Lb1163) / 2, 0
.Lb1163:
shsax r12, r11, r11
.Le1163:
.balign 4
.hword (.Le1164 - .Lb1164) / 2, 0
.Lb1164:
usax r12, r11, r10
.Le1164:
.balign 4
.hword (.Le1165 - .Lb1165) / 2, 0
.Lb1165:
usax r12, r10, r11
.Le1165:
.balign 4
.hword (.Le1166 - .Lb1166) / 2, 0
.Lb1166:
uqsax r3, r12, r9
.Le1166:
.balign 4
.hword (.Le1167 - .Lb1167) / 2, 0
.Lb1167:
uqsax lr, r11, r10
.Le1167:
.balign 4
.hword (.Le1168 - .Lb1168) / 2, 0
.Lb1168:
uhsax r0, r3, r0
.Le1168:
.balign 4
.hword (.Le1169 - .Lb1169) / 2, 0
.Lb1169:
uhsax r5, r9, lr
.Le1169:
.balign 4
.hword 0xffff, 0
.balign 4
group_parallel_sub8:
.balign 4
.hword (.Le1170 - .Lb1170) / 2, 0
.Lb1170:
ssub8 r10, r12, r12
.Le1170:
.balign 4
.hword (.Le1171 - .Lb1171) / 2, 0
.Lb1171:
ssub8 r0, r3, r12
.Le1171:
.balign 4
.hword (.Le1172 - .Lb1172) / 2, 0
.Lb1172:
qsub8 r5, r9, lr
.Le1172:
.balign 4
.hword (.Le1173 - .Lb1173) / 2, 0
.Lb1173:
qsub8 r12, lr, r3
.Le1173:
.balign 4
.hword (.Le1174 - .Lb1174) / 2, 0
.Lb1174:
shsub8 r12, r5, lr
.Le1174:
.balign 4
.hword (.Le1175 - .Lb1175) / 2, 0
.Lb1175:
shsub8 r9, r10, r0
.Le1175:
.balign 4
.hword (.Le1176 - .Lb1176) / 2, 0
.Lb1176:
usub8 r10, r10, r5
.Le1176:
.balign 4
.hword (.Le1177 - .Lb1177) / 2, 0
.Lb1177:
usub8 r10, r10, lr
.Le1177:
.balign 4
.hword (.Le1178 - .Lb1178) / 2, 0
.Lb1178:
uqsub8 r5, r12, r11
.Le1178:
.balign 4
.hword (.Le1179 - .Lb1179) / 2, 0
.Lb1179:
uqsub8 r11, r9, r10
.Le1179:
.balign 4
.hword (.Le1180 - .Lb1180) / 2, 0
.Lb1180:
uhsub8 r0, r10, r10
.Le1180:
.balign 4
.hword (.Le1181 - .Lb1181) / 2, 0
.Lb1181:
uhsub8 lr, r10, r10
.Le1181:
.balign 4
.hword 0xffff, 0
.balign 4
group_parallel_sub16:
.balign 4
.hword (.Le1182 - .Lb1182) / 2, 0
.Lb1182:
ssub16 r5, r10, r10
.Le1182:
.balign 4
.hword (.Le1183 - .Lb1183) / 2, 0
.Lb1183:
ssub16 r11, r5, r10
.Le1183:
.balign 4
.hword (.Le1184 - .Lb1184) / 2, 0
.Lb1184:
qsub16 r12, lr, lr
.Le1184:
.balign 4
.hword (.Le1185 - .Lb1185) / 2, 0
.Lb1185:
qsub16 r5, r12, r0
.Le1185:
.balign 4
.hword (.Le1186 - .Lb1186) / 2, 0
.Lb1186:
shsub16 r3, r9, r11
.Le1186:
.balign 4
.hword (.Le1187 - .Lb1187) / 2, 0
.Lb1187:
shsub16 r0, r10, r0
.Le1187:
.balign 4
.hword (.Le1188 - .Lb1188) / 2, 0
.Lb1188:
usub16 r12, r3, r11
.Le1188:
.balign 4
.hword (.Le1189 - .Lb1189) / 2, 0
.Lb1189:
usub16 r5, r0, r11
.Le1189:
.balign 4
.hword (.Le1190 - .Lb1190) / 2, 0
.Lb1190:
uqsub16 r9, r11, r12
.Le1190:
.balign 4
.hword (.Le1191 - .Lb1191) / 2, 0
.Lb1191:
uqsub16 r9, r3, r0
.Le1191:
.balign 4
.hword (.Le1192 - .Lb1192) / 2, 0
.Lb1192:
uhsub16 r11, r0, lr
.Le1192:
.balign 4
.hword (.Le1193 - .Lb1193) / 2, 0
.Lb1193:
uhsub16 r0, r5, r10
.Le1193:
.balign 4
.hword 0xffff, 0
.balign 4
group_mul:
.balign 4
.hword (.Le1194 - .Lb1194) / 2, 0
.Lb1194:
mla r9, r12, r10, r6
.Le1194:
.balign 4
.hword (.Le1195 - .Lb1195) / 2, 0
.Lb1195:
mla r5, r0, r0, r6
.Le1195:
.balign 4
.hword (.Le1196 - .Lb1196) / 2, 0
.Lb1196:
mla lr, r12, r3, r6
.Le1196:
.balign 4
.hword (.Le1197 - .Lb1197) / 2, 0
.Lb1197:
mls r12, r10, r12, r6
.Le1197:
.balign 4
.hword (.Le1198 - .Lb1198) / 2, 0
.Lb1198:
mls r0, r9, r11, r6
.Le1198:
.balign 4
.hword (.Le1199 - .Lb1199) / 2, 0
.Lb1199:
mls r12, lr, r9, r6
.Le1199:
.balign 4
.hword (.Le1200 - .Lb1200) / 2, 0
.Lb1200:
mul r3, r11, r12
.Le1200:
.balign 4
.hword (.Le1201 - .Lb1201) / 2, 0
.Lb1201:
mul r5, r9, lr
.Le1201:
.balign 4
.hword (.Le1202 - .Lb1202) / 2, 0
.Lb1202:
mul r3, r12, r12
.Le1202:
.balign 4
.hword 0xffff, 0
.balign 4
group_long_mul:
.balign 4
.hword (.Le1203 - .Lb1203) / 2, 0
.Lb1203:
umull r0, r5, r10, r0
.Le1203:
.balign 4
.hword (.Le1204 - .Lb1204) / 2, 0
.Lb1204:
umull r0, r5, r0, r10
.Le1204:
.balign 4
.hword (.Le1205 - .Lb1205) / 2, 0
.Lb1205:
umull r0, r5, r5, r10
.Le1205:
.balign 4
.hword (.Le1206 - .Lb1206) / 2, 0
.Lb1206:
smull r0, r5, r12, r10
.Le1206:
.balign 4
.hword (.Le1207 - .Lb1207) / 2, 0
.Lb1207:
smull r0, r5, r10, r0
.Le1207:
.balign 4
.hword (.Le1208 - .Lb1208) / 2, 0
.Lb1208:
smull r0, r5, r5, r10
.Le1208:
.balign 4
.hword (.Le1209 - .Lb1209) / 2, 0
.Lb1209:
umlal r0, r5, r5, r0
.Le1209:
.balign 4
.hword (.Le1210 - .Lb1210) / 2, 0
.Lb1210:
umlal r0, r5, r0, r10
.Le1210:
.balign 4
.hword (.Le1211 - .Lb1211) / 2, 0
.Lb1211:
umlal r0, r5, r12, r11
.Le1211:
.balign 4
.hword (.Le1212 - .Lb1212) / 2, 0
.Lb1212:
smlal r0, r5, r10, r5
.Le1212:
.balign 4
.hword (.Le1213 - .Lb1213) / 2, 0
.Lb1213:
smlal r0, r5, r3, r5
.Le1213:
.balign 4
.hword (.Le1214 - .Lb1214) / 2, 0
.Lb1214:
smlal r0, r5, r0, r9
.Le1214:
.balign 4
.hword (.Le1215 - .Lb1215) / 2, 0
.Lb1215:
umaal r0, r5, r0, r0
.Le1215:
.balign 4
.hword (.Le1216 - .Lb1216) / 2, 0
.Lb1216:
umaal r0, r5, r5, r0
.Le1216:
.balign 4
.hword (.Le1217 - .Lb1217) / 2, 0
.Lb1217:
umaal r0, r5, r12, r9
.Le1217:
.balign 4
.hword 0xffff, 0
.balign 4
group_dsp16:
.balign 4
.hword (.Le1218 - .Lb1218) / 2, 0
.Lb1218:
smulbb r5, r9, r3
.Le1218:
.balign 4
.hword (.Le1219 - .Lb1219) / 2, 0
.Lb1219:
smulbb lr, r11, r10
.Le1219:
.balign 4
.hword (.Le1220 - .Lb1220) / 2, 0
.Lb1220:
smulbt r9, r10, r12
.Le1220:
.balign 4
.hword (.Le1221 - .Lb1221) / 2, 0
.Lb1221:
smulbt r9, r10, r10
.Le1221:
.balign 4
.hword (.Le1222 - .Lb1222) / 2, 0
.Lb1222:
smultb r5, r10, r11
.Le1222:
.balign 4
.hword (.Le1223 - .Lb1223) / 2, 0
.Lb1223:
smultb r10, r9, r9
.Le1223:
.balign 4
.hword (.Le1224 - .Lb1224) / 2, 0
.Lb1224:
smultt r0, r3, r9
.Le1224:
.balign 4
.hword (.Le1225 - .Lb1225) / 2, 0
.Lb1225:
smultt r10, r5, r11
.Le1225:
.balign 4
.hword (.Le1226 - .Lb1226) / 2, 0
.Lb1226:
smlabb r9, r5, r0, r6
.Le1226:
.balign 4
.hword (.Le1227 - .Lb1227) / 2, 0
.Lb1227:
smlabb r9, r12, r10, r6
.Le1227:
.balign 4
.hword (.Le1228 - .Lb1228) / 2, 0
.Lb1228:
smlabt r10, r9, r10, r6
.Le1228:
.balign 4
.hword (.Le1229 - .Lb1229) / 2, 0
.Lb1229:
smlabt r12, r0, r0, r6
.Le1229:
.balign 4
.hword (.Le1230 - .Lb1230) / 2, 0
.Lb1230:
smlatb r5, lr, r12, r6
.Le1230:
.balign 4
.hword (.Le1231 - .Lb1231) / 2, 0
.Lb1231:
smlatb r10, r11, r12, r6
.Le1231:
.balign 4
.hword (.Le1232 - .Lb1232) / 2, 0
.Lb1232:
smlatt r11, r9, r10, r6
.Le1232:
.balign 4
.hword (.Le1233 - .Lb1233) / 2, 0
.Lb1233:
smlatt r10, r10, lr, r6
.Le1233:
.balign 4
.hword (.Le1234 - .Lb1234) / 2, 0
.Lb1234:
smulwb r5, r11, r5
.Le1234:
.balign 4
.hword (.Le1235 - .Lb1235) / 2, 0
.Lb1235:
smulwb r12, r0, r3
.Le1235:
.balign 4
.hword (.Le1236 - .Lb1236) / 2, 0
.Lb1236:
smulwt r10, r3, lr
.Le1236:
.balign 4
.hword (.Le1237 - .Lb1237) / 2, 0
.Lb1237:
smulwt r9, lr, r10
.Le1237:
.balign 4
.hword (.Le1238 - .Lb1238) / 2, 0
.Lb1238:
smlawb r0, r10, r11, r6
.Le1238:
.balign 4
.hword (.Le1239 - .Lb1239) / 2, 0
.Lb1239:
smlawb r0, lr, r12, r6
.Le1239:
.balign 4
.hword (.Le1240 - .Lb1240) / 2, 0
.Lb1240:
smlawt r12, r12, r11, r6
.Le1240:
.balign 4
.hword (.Le1241 - .Lb1241) / 2, 0
.Lb1241:
smlawt lr, r9, r12, r6
.Le1241:
.balign 4
.hword (.Le1242 - .Lb1242) / 2, 0
.Lb1242:
smlalbb r0, r5, r10, r3
.Le1242:
.balign 4
.hword (.Le1243 - .Lb1243) / 2, 0
.Lb1243:
smlalbb r0, r5, r5, r11
.Le1243:
.balign 4
.hword (.Le1244 - .Lb1244) / 2, 0
.Lb1244:
smlalbt r0, r5, r12, r12
.Le1244:
.balign 4
.hword (.Le1245 - .Lb1245) / 2, 0
.Lb1245:
smlalbt r0, r5, r12, r0
.Le1245:
.balign 4
.hword (.Le1246 - .Lb1246) / 2, 0
.Lb1246:
smlaltb r0, r5, r9, r3
.Le1246:
.balign 4
.hword (.Le1247 - .Lb1247) / 2, 0
.Lb1247:
smlaltb r0, r5, lr, r12
.Le1247:
.balign 4
.hword (.Le1248 - .Lb1248) / 2, 0
.Lb1248:
smlaltt r0, r5, r5, r9
.Le1248:
.balign 4
.hword (.Le1249 - .Lb1249) / 2, 0
.Lb1249:
smlaltt r0, r5, r11, r11
.Le1249:
.balign 4
.hword 0xffff, 0
.balign 4
group_dsp_dual:
.balign 4
.hword (.Le1250 - .Lb1250) / 2, 0
.Lb1250:
smuad lr, r5, r12
.Le1250:
.balign 4
.hword (.Le1251 - .Lb1251) / 2, 0
.Lb1251:
smuad lr, r5, r0
.Le1251:
.balign 4
.hword (.Le1252 - .Lb1252) / 2, 0
.Lb1252:
smuadx r9, r9, r5
.Le1252:
.balign 4
.hword (.Le1253 - .Lb1253) / 2, 0
.Lb1253:
smuadx r3, r10, r0
.Le1253:
.balign 4
.hword (.Le1254 - .Lb1254) / 2, 0
.Lb1254:
smusd r0, r11, r10
.Le1254:
.balign 4
.hword (.Le1255 - .Lb1255) / 2, 0
.Lb1255:
smusd r9, r0, r10
.Le1255:
.balign 4
.hword (.Le1256 - .Lb1256) / 2, 0
.Lb1256:
smusdx r5, r5, r3
.Le1256:
.balign 4
.hword (.Le1257 - .Lb1257) / 2, 0
.Lb1257:
smusdx r5, r12, r10
.Le1257:
.balign 4
.hword (.Le1258 - .Lb1258) / 2, 0
.Lb1258:
smlad r5, r3, r9, r6
.Le1258:
.balign 4
.hword (.Le1259 - .Lb1259) / 2, 0
.Lb1259:
smlad r5, r12, r9, r6
.Le1259:
.balign 4
.hword (.Le1260 - .Lb1260) / 2, 0
.Lb1260:
smladx r12, lr, r5, r6
.Le1260:
.balign 4
.hword (.Le1261 - .Lb1261) / 2, 0
.Lb1261:
smladx r3, lr, r9, r6
.Le1261:
.balign 4
.hword (.Le1262 - .Lb1262) / 2, 0
.Lb1262:
smlsd r9, r3, r5, r6
.Le1262:
.balign 4
.hword (.Le1263 - .Lb1263) / 2, 0
.Lb1263:
smlsd r9, r9, r5, r6
.Le1263:
.balign 4
.hword (.Le1264 - .Lb1264) / 2, 0
.Lb1264:
smlsdx r10, r3, r11, r6
.Le1264:
.balign 4
.hword (.Le1265 - .Lb1265) / 2, 0
.Lb1265:
smlsdx r3, r11, r10, r6
.Le1265:
.balign 4
.hword (.Le1266 - .Lb1266) / 2, 0
.Lb1266:
smlald r0, r5, lr, r12
.Le1266:
.balign 4
.hword (.Le1267 - .Lb1267) / 2, 0
.Lb1267:
smlald r0, r5, r5, r3
.Le1267:
.balign 4
.hword (.Le1268 - .Lb1268) / 2, 0
.Lb1268:
smlaldx r0, r5, r12, r11
.Le1268:
.balign 4
.hword (.Le1269 - .Lb1269) / 2, 0
.Lb1269:
smlaldx r0, r5, lr, r12
.Le1269:
.balign 4
.hword (.Le1270 - .Lb1270) / 2, 0
.Lb1270:
smlsld r0, r5, r5, r0
.Le1270:
.balign 4
.hword (.Le1271 - .Lb1271) / 2, 0
.Lb1271:
smlsld r0, r5, r11, lr
.Le1271:
.balign 4
.hword (.Le1272 - .Lb1272) / 2, 0
.Lb1272:
smlsldx r0, r5, lr, r11
.Le1272:
.balign 4
.hword (.Le1273 - .Lb1273) / 2, 0
.Lb1273:
smlsldx r0, r5, r5, lr
.Le1273:
.balign 4
.hword 0xffff, 0
.balign 4
group_dsp_high:
.balign 4
.hword (.Le1274 - .Lb1274) / 2, 0
.Lb1274:
smmul r9, lr, r10
.Le1274:
.balign 4
.hword (.Le1275 - .Lb1275) / 2, 0
.Lb1275:
smmul r9, r5, r9
.Le1275:
.balign 4
.hword (.Le1276 - .Lb1276) / 2, 0
.Lb1276:
smmulr r10, r3, r3
.Le1276:
.balign 4
.hword (.Le1277 - .Lb1277) / 2, 0
.Lb1277:
smmulr r9, r12, r9
.Le1277:
.balign 4
.hword (.Le1278 - .Lb1278) / 2, 0
.Lb1278:
smmla r10, lr, r0, r6
.Le1278:
.balign 4
.hword (.Le1279 - .Lb1279) / 2, 0
.Lb1279:
smmla r12, r9, r0, r6
.Le1279:
.balign 4
.hword (.Le1280 - .Lb1280) / 2, 0
.Lb1280:
smmlar r10, r10, r9, r6
.Le1280:
.balign 4
.hword (.Le1281 - .Lb1281) / 2, 0
.Lb1281:
smmlar r12, r0, lr, r6
.Le1281:
.balign 4
.hword (.Le1282 - .Lb1282) / 2, 0
.Lb1282:
smmls r11, r12, r9, r6
.Le1282:
.balign 4
.hword (.Le1283 - .Lb1283) / 2, 0
.Lb1283:
smmls r3, r5, r0, r6
.Le1283:
.balign 4
.hword (.Le1284 - .Lb1284) / 2, 0
.Lb1284:
smmlsr r12, r5, r0, r6
.Le1284:
.balign 4
.hword (.Le1285 - .Lb1285) / 2, 0
.Lb1285:
smmlsr lr, lr, r11, r6
.Le1285:
.balign 4
.hword (.Le1286 - .Lb1286) / 2, 0
.Lb1286:
usad8 r12, r0, r12
.Le1286:
.balign 4
.hword (.Le1287 - .Lb1287) / 2, 0
.Lb1287:
usad8 r12, r9, r0
.Le1287:
.balign 4
.hword (.Le1288 - .Lb1288) / 2, 0
.Lb1288:
usada8 r0, r9, r11, r6
.Le1288:
.balign 4
.hword (.Le1289 - .Lb1289) / 2, 0
.Lb1289:
usada8 r0, r5, lr, r6
.Le1289:
.balign 4
.hword 0xffff, 0
.balign 4
group_div:
.balign 4
.hword (.Le1290 - .Lb1290) / 2, 0
.Lb1290:
udiv r5, lr, r5
.Le1290:
.balign 4
.hword (.Le1291 - .Lb1291) / 2, 0
.Lb1291:
udiv r5, r10, r12
.Le1291:
.balign 4
.hword (.Le1292 - .Lb1292) / 2, 0
.Lb1292:
udiv r3, r3, r3
.Le1292:
.balign 4
.hword (.Le1293 - .Lb1293) / 2, 0
.Lb1293:
udiv r12, lr, r11
.Le1293:
.balign 4
.hword (.Le1294 - .Lb1294) / 2, 0
.Lb1294:
udiv r9, r0, r12
.Le1294:
.balign 4
.hword (.Le1295 - .Lb1295) / 2, 0
.Lb1295:
udiv r9, lr, r9
.Le1295:
.balign 4
.hword (.Le1296 - .Lb1296) / 2, 0
.Lb1296:
sdiv r5, r9, r9
.Le1296:
.balign 4
.hword (.Le1297 - .Lb1297) / 2, 0
.Lb1297:
sdiv r11, r10, lr
.Le1297:
.balign 4
.hword (.Le1298 - .Lb1298) / 2, 0
.Lb1298:
sdiv r9, r9, r10
.Le1298:
.balign 4
.hword (.Le1299 - .Lb1299) / 2, 0
.Lb1299:
sdiv r3, r0, r0
.Le1299:
.balign 4
.hword (.Le1300 - .Lb1300) / 2, 0
.Lb1300:
sdiv r11, r3, r5
.Le1300:
.balign 4
.hword (.Le1301 - .Lb1301) / 2, 0
.Lb1301:
sdiv lr, r3, r12
.Le1301:
.balign 4
.hword 0xffff, 0
.balign 4
group_branch:
.balign 4
.hword (.Le1302 - .Lb1302) / 2, 0
.Lb1302:
beq 1f
movs r0, #1
1: nop
.Le1302:
.balign 4
.hword (.Le1303 - .Lb1303) / 2, 0
.Lb1303:
bne 1f
movs r0, #1
1: nop
.Le1303:
.balign 4
.hword (.Le1304 - .Lb1304) / 2, 0
.Lb1304:
bcs 1f
movs r0, #1
1: nop
.Le1304:
.balign 4
.hword (.Le1305 - .Lb1305) / 2, 0
.Lb1305:
bcc 1f
movs r0, #1
1: nop
.Le1305:
.balign 4
.hword (.Le1306 - .Lb1306) / 2, 0
.Lb1306:
bmi 1f
movs r0, #1
1: nop
.Le1306:
.balign 4
.hword (.Le1307 - .Lb1307) / 2, 0
.Lb1307:
bpl 1f
movs r0, #1
1: nop
.Le1307:
.balign 4
.hword (.Le1308 - .Lb1308) / 2, 0
.Lb1308:
bvs 1f
movs r0, #1
1: nop
.Le1308:
.balign 4
.hword (.Le1309 - .Lb1309) / 2, 0
.Lb1309:
bvc 1f
movs r0, #1
1: nop
.Le1309:
.balign 4
.hword (.Le1310 - .Lb1310) / 2, 0
.Lb1310:
bhi 1f
movs r0, #1
1: nop
.Le1310:
.balign 4
.hword (.Le1311 - .Lb1311) / 2, 0
.Lb1311:
bls 1f
movs r0, #1
1: nop
.Le1311:
.balign 4
.hword (.Le1312 - .Lb1312) / 2, 0
.Lb1312:
bge 1f
movs r0, #1
1: nop
.Le1312:
.balign 4
.hword (.Le1313 - .Lb1313) / 2, 0
.Lb1313:
blt 1f
movs r0, #1
1: nop
.Le1313:
.balign 4
.hword (.Le1314 - .Lb1314) / 2, 0
.Lb1314:
bgt 1f
movs r0, #1
1: nop
.Le1314:
.balign 4
.hword (.Le1315 - .Lb1315) / 2, 0
.Lb1315:
ble 1f
movs r0, #1
1: nop
.Le1315:
.balign 4
.hword (.Le1316 - .Lb1316) / 2, 0
.Lb1316:
beq.w 1f
movs r0, #1
1: nop
.Le1316:
.balign 4
.hword (.Le1317 - .Lb1317) / 2, 0
.Lb1317:
bne.w 1f
movs r0, #1
1: nop
.Le1317:
.balign 4
.hword (.Le1318 - .Lb1318) / 2, 0
.Lb1318:
bcs.w 1f
movs r0, #1
1: nop
.Le1318:
.balign 4
.hword (.Le1319 - .Lb1319) / 2, 0
.Lb1319:
bcc.w 1f
movs r0, #1
1: nop
.Le1319:
.balign 4
.hword (.Le1320 - .Lb1320) / 2, 0
.Lb1320:
bmi.w 1f
movs r0, #1
1: nop
.Le1320:
.balign 4
.hword (.Le1321 - .Lb1321) / 2, 0
.Lb1321:
bpl.w 1f
movs r0, #1
1: nop
.Le1321:
.balign 4
.hword (.Le1322 - .Lb1322) / 2, 0
.Lb1322:
bvs.w 1f
movs r0, #1
1: nop
.Le1322:
.balign 4
.hword (.Le1323 - .Lb1323) / 2, 0
.Lb1323:
bvc.w 1f
movs r0, #1
1: nop
.Le1323:
.balign 4
.hword (.Le1324 - .Lb1324) / 2, 0
.Lb1324:
bhi.w 1f
movs r0, #1
1: nop
.Le1324:
.balign 4
.hword (.Le1325 - .Lb1325) / 2, 0
.Lb1325:
bls.w 1f
movs r0, #1
1: nop
.Le1325:
.balign 4
.hword (.Le1326 - .Lb1326) / 2, 0
.Lb1326:
bge.w 1f
movs r0, #1
1: nop
.Le1326:
.balign 4
.hword (.Le1327 - .Lb1327) / 2, 0
.Lb1327:
blt.w 1f
movs r0, #1
1: nop
.Le1327:
.balign 4
.hword (.Le1328 - .Lb1328) / 2, 0
.Lb1328:
bgt.w 1f
movs r0, #1
1: nop
.Le1328:
.balign 4
.hword (.Le1329 - .Lb1329) / 2, 0
.Lb1329:
ble.w 1f
movs r0, #1
1: nop
.Le1329:
.balign 4
.hword (.Le1330 - .Lb1330) / 2, 0
.Lb1330:
b 1f
movs r0, #1
1: nop
.Le1330:
.balign 4
.hword (.Le1331 - .Lb1331) / 2, 0
.Lb1331:
b.w 1f
movs r0, #1
1: nop
.Le1331:
.balign 4
.hword (.Le1332 - .Lb1332) / 2, 0
.Lb1332:
cbz r0, 1f
movs r1, #1
1: nop
.Le1332:
.balign 4
.hword (.Le1333 - .Lb1333) / 2, 0
.Lb1333:
cbnz r0, 1f
movs r1, #1
1: nop
.Le1333:
.balign 4
.hword (.Le1334 - .Lb1334) / 2, 0
.Lb1334:
cbz r2, 1f
movs r1, #1
1: nop
.Le1334:
.balign 4
.hword (.Le1335 - .Lb1335) / 2, 0
.Lb1335:
bl 1f
movs r0, #1
1: nop
.Le1335:
.balign 4
.hword (.Le1336 - .Lb1336) / 2, 0
.Lb1336:
adr r0, 1f
adds r0, #1
bx r0
movs r1, #9
.balign 4
1: nop
.Le1336:
.balign 4
.hword (.Le1337 - .Lb1337) / 2, 0
.Lb1337:
adr r0, 1f
adds r0, #1
blx r0
movs r1, #9
.balign 4
1: nop
.Le1337:
.balign 4
.hword (.Le1338 - .Lb1338) / 2, 0
.Lb1338:
movs r0, #1
tbb [pc, r0]
.byte 2, 3
movs r1, #9
movs r2, #8
movs r3, #7
.Le1338:
.balign 4
.hword (.Le1339 - .Lb1339) / 2, 0
.Lb1339:
movs r0, #1
tbh [pc, r0, lsl #1]
.hword 2, 3
movs r1, #9
movs r2, #8
movs r3, #7
.Le1339:
.balign 4
.hword 0xffff, 0
.balign 4
group_it:
.balign 4
.hword (.Le1340 - .Lb1340) / 2, 0
.Lb1340:
it eq
moveq r0, r9
.Le1340:
.balign 4
.hword (.Le1341 - .Lb1341) / 2, 0
.Lb1341:
it ne
movne r0, r9
.Le1341:
.balign 4
.hword (.Le1342 - .Lb1342) / 2, 0
.Lb1342:
it cs
movcs r0, r9
.Le1342:
.balign 4
.hword (.Le1343 - .Lb1343) / 2, 0
.Lb1343:
it cc
movcc r0, r9
.Le1343:
.balign 4
.hword (.Le1344 - .Lb1344) / 2, 0
.Lb1344:
it mi
movmi r0, r9
.Le1344:
.balign 4
.hword (.Le1345 - .Lb1345) / 2, 0
.Lb1345:
it pl
movpl r0, r9
.Le1345:
.balign 4
.hword (.Le1346 - .Lb1346) / 2, 0
.Lb1346:
it vs
movvs r0, r9
.Le1346:
.balign 4
.hword (.Le1347 - .Lb1347) / 2, 0
.Lb1347:
it vc
movvc r0, r9
.Le1347:
.balign 4
.hword (.Le1348 - .Lb1348) / 2, 0
.Lb1348:
it hi
movhi r0, r9
.Le1348:
.balign 4
.hword (.Le1349 - .Lb1349) / 2, 0
.Lb1349:
it ls
movls r0, r9
.Le1349:
.balign 4
.hword (.Le1350 - .Lb1350) / 2, 0
.Lb1350:
it ge
movge r0, r9
.Le1350:
.balign 4
.hword (.Le1351 - .Lb1351) / 2, 0
.Lb1351:
it lt
movlt r0, r9
.Le1351:
.balign 4
.hword (.Le1352 - .Lb1352) / 2, 0
.Lb1352:
it gt
movgt r0, r9
.Le1352:
.balign 4
.hword (.Le1353 - .Lb1353) / 2, 0
.Lb1353:
it le
movle r0, r9
.Le1353:
.balign 4
.hword (.Le1354 - .Lb1354) / 2, 0
.Lb1354:
ite eq
addeq r0, r1, r2
subne r0, r1, r2
.Le1354:
.balign 4
.hword (.Le1355 - .Lb1355) / 2, 0
.Lb1355:
ite cs
addcs r0, r1, r2
subcc r0, r1, r2
.Le1355:
.balign 4
.hword (.Le1356 - .Lb1356) / 2, 0
.Lb1356:
ite mi
addmi r0, r1, r2
subpl r0, r1, r2
.Le1356:
.balign 4
.hword (.Le1357 - .Lb1357) / 2, 0
.Lb1357:
ite vs
addvs r0, r1, r2
subvc r0, r1, r2
.Le1357:
.balign 4
.hword (.Le1358 - .Lb1358) / 2, 0
.Lb1358:
ite hi
addhi r0, r1, r2
subls r0, r1, r2
.Le1358:
.balign 4
.hword (.Le1359 - .Lb1359) / 2, 0
.Lb1359:
ite ge
addge r0, r1, r2
sublt r0, r1, r2
.Le1359:
.balign 4
.hword (.Le1360 - .Lb1360) / 2, 0
.Lb1360:
ite gt
addgt r0, r1, r2
suble r0, r1, r2
.Le1360:
.balign 4
.hword (.Le1361 - .Lb1361) / 2, 0
.Lb1361:
itt eq
lsleq r0, r1, #3
addeq r3, #200
.Le1361:
.balign 4
.hword (.Le1362 - .Lb1362) / 2, 0
.Lb1362:
itt ne
lslne r0, r1, #3
addne r3, #200
.Le1362:
.balign 4
.hword (.Le1363 - .Lb1363) / 2, 0
.Lb1363:
itt cs
lslcs r0, r1, #3
addcs r3, #200
.Le1363:
.balign 4
.hword (.Le1364 - .Lb1364) / 2, 0
.Lb1364:
itt cc
lslcc r0, r1, #3
addcc r3, #200
.Le1364:
.balign 4
.hword (.Le1365 - .Lb1365) / 2, 0
.Lb1365:
itt mi
lslmi r0, r1, #3
addmi r3, #200
.Le1365:
.balign 4
.hword (.Le1366 - .Lb1366) / 2, 0
.Lb1366:
itt pl
lslpl r0, r1, #3
addpl r3, #200
.Le1366:
.balign 4
.hword (.Le1367 - .Lb1367) / 2, 0
.Lb1367:
itt vs
lslvs r0, r1, #3
addvs r3, #200
.Le1367:
.balign 4
.hword (.Le1368 - .Lb1368) / 2, 0
.Lb1368:
itt vc
lslvc r0, r1, #3
addvc r3, #200
.Le1368:
.balign 4
.hword (.Le1369 - .Lb1369) / 2, 0
.Lb1369:
itt hi
lslhi r0, r1, #3
addhi r3, #200
.Le1369:
.balign 4
.hword (.Le1370 - .Lb1370) / 2, 0
.Lb1370:
itt ls
lslls r0, r1, #3
addls r3, #200
.Le1370:
.balign 4
.hword (.Le1371 - .Lb1371) / 2, 0
.Lb1371:
itt ge
lslge r0, r1, #3
addge r3, #200
.Le1371:
.balign 4
.hword (.Le1372 - .Lb1372) / 2, 0
.Lb1372:
itt lt
lsllt r0, r1, #3
addlt r3, #200
.Le1372:
.balign 4
.hword (.Le1373 - .Lb1373) / 2, 0
.Lb1373:
itt gt
lslgt r0, r1, #3
addgt r3, #200
.Le1373:
.balign 4
.hword (.Le1374 - .Lb1374) / 2, 0
.Lb1374:
itt le
lslle r0, r1, #3
addle r3, #200
.Le1374:
.balign 4
.hword (.Le1375 - .Lb1375) / 2, 0
.Lb1375:
ittee eq
cmpeq r0, r1
muleq r2, r3, r2
andne r4, r5
adcne r0, r1
.Le1375:
.balign 4
.hword (.Le1376 - .Lb1376) / 2, 0
.Lb1376:
ittee cs
cmpcs r0, r1
mulcs r2, r3, r2
andcc r4, r5
adccc r0, r1
.Le1376:
.balign 4
.hword (.Le1377 - .Lb1377) / 2, 0
.Lb1377:
ittee mi
cmpmi r0, r1
mulmi r2, r3, r2
andpl r4, r5
adcpl r0, r1
.Le1377:
.balign 4
.hword (.Le1378 - .Lb1378) / 2, 0
.Lb1378:
ittee vs
cmpvs r0, r1
mulvs r2, r3, r2
andvc r4, r5
adcvc r0, r1
.Le1378:
.balign 4
.hword (.Le1379 - .Lb1379) / 2, 0
.Lb1379:
ittee hi
cmphi r0, r1
mulhi r2, r3, r2
andls r4, r5
adcls r0, r1
.Le1379:
.balign 4
.hword (.Le1380 - .Lb1380) / 2, 0
.Lb1380:
ittee ge
cmpge r0, r1
mulge r2, r3, r2
andlt r4, r5
adclt r0, r1
.Le1380:
.balign 4
.hword (.Le1381 - .Lb1381) / 2, 0
.Lb1381:
ittee gt
cmpgt r0, r1
mulgt r2, r3, r2
andle r4, r5
adcle r0, r1
.Le1381:
.balign 4
.hword (.Le1382 - .Lb1382) / 2, 0
.Lb1382:
itet eq
andseq.w r0, r1, r2
rsbne r3, r4, #0
mvneq r5, r6
.Le1382:
.balign 4
.hword (.Le1383 - .Lb1383) / 2, 0
.Lb1383:
itet cs
andscs.w r0, r1, r2
rsbcc r3, r4, #0
mvncs r5, r6
.Le1383:
.balign 4
.hword (.Le1384 - .Lb1384) / 2, 0
.Lb1384:
itet mi
andsmi.w r0, r1, r2
rsbpl r3, r4, #0
mvnmi r5, r6
.Le1384:
.balign 4
.hword (.Le1385 - .Lb1385) / 2, 0
.Lb1385:
itet vs
andsvs.w r0, r1, r2
rsbvc r3, r4, #0
mvnvs r5, r6
.Le1385:
.balign 4
.hword (.Le1386 - .Lb1386) / 2, 0
.Lb1386:
itet hi
andshi.w r0, r1, r2
rsbls r3, r4, #0
mvnhi r5, r6
.Le1386:
.balign 4
.hword (.Le1387 - .Lb1387) / 2, 0
.Lb1387:
itet ge
andsge.w r0, r1, r2
rsblt r3, r4, #0
mvnge r5, r6
.Le1387:
.balign 4
.hword (.Le1388 - .Lb1388) / 2, 0
.Lb1388:
itet gt
andsgt.w r0, r1, r2
rsble r3, r4, #0
mvngt r5, r6
.Le1388:
.balign 4
.hword (.Le1389 - .Lb1389) / 2, 0
.Lb1389:
itttt eq
lsreq r0, r3
movseq.w r1, #0
eoreq r2, r3
moveq r4, #77
.Le1389:
.balign 4
.hword (.Le1390 - .Lb1390) / 2, 0
.Lb1390:
itttt ne
lsrne r0, r3
movsne.w r1, #0
eorne r2, r3
movne r4, #77
.Le1390:
.balign 4
.hword (.Le1391 - .Lb1391) / 2, 0
.Lb1391:
itttt cs
lsrcs r0, r3
movscs.w r1, #0
eorcs r2, r3
movcs r4, #77
.Le1391:
.balign 4
.hword (.Le1392 - .Lb1392) / 2, 0
.Lb1392:
itttt cc
lsrcc r0, r3
movscc.w r1, #0
eorcc r2, r3
movcc r4, #77
.Le1392:
.balign 4
.hword (.Le1393 - .Lb1393) / 2, 0
.Lb1393:
itttt mi
lsrmi r0, r3
movsmi.w r1, #0
eormi r2, r3
movmi r4, #77
.Le1393:
.balign 4
.hword (.Le1394 - .Lb1394) / 2, 0
.Lb1394:
itttt pl
lsrpl r0, r3
movspl.w r1, #0
eorpl r2, r3
movpl r4, #77
.Le1394:
.balign 4
.hword (.Le1395 - .Lb1395) / 2, 0
.Lb1395:
itttt vs
lsrvs r0, r3
movsvs.w r1, #0
eorvs r2, r3
movvs r4, #77
.Le1395:
.balign 4
.hword (.Le1396 - .Lb1396) / 2, 0
.Lb1396:
itttt vc
lsrvc r0, r3
movsvc.w r1, #0
eorvc r2, r3
movvc r4, #77
.Le1396:
.balign 4
.hword (.Le1397 - .Lb1397) / 2, 0
.Lb1397:
itttt hi
lsrhi r0, r3
movshi.w r1, #0
eorhi r2, r3
movhi r4, #77
.Le1397:
.balign 4
.hword (.Le1398 - .Lb1398) / 2, 0
.Lb1398:
itttt ls
lsrls r0, r3
movsls.w r1, #0
eorls r2, r3
movls r4, #77
.Le1398:
.balign 4
.hword (.Le1399 - .Lb1399) / 2, 0
.Lb1399:
itttt ge
lsrge r0, r3
movsge.w r1, #0
eorge r2, r3
movge r4, #77
.Le1399:
.balign 4
.hword (.Le1400 - .Lb1400) / 2, 0
.Lb1400:
itttt lt
lsrlt r0, r3
movslt.w r1, #0
eorlt r2, r3
movlt r4, #77
.Le1400:
.balign 4
.hword (.Le1401 - .Lb1401) / 2, 0
.Lb1401:
itttt gt
lsrgt r0, r3
movsgt.w r1, #0
eorgt r2, r3
movgt r4, #77
.Le1401:
.balign 4
.hword (.Le1402 - .Lb1402) / 2, 0
.Lb1402:
itttt le
lsrle r0, r3
movsle.w r1, #0
eorle r2, r3
movle r4, #77
.Le1402:
.balign 4
.hword 0xffff, 0
.balign 4
group_load_imm:
.balign 4
.hword (.Le1403 - .Lb1403) / 2, 0
.Lb1403:
ldr.w r5, [r7, #0]
.Le1403:
.balign 4
.hword (.Le1404 - .Lb1404) / 2, 0
.Lb1404:
ldr.w r0, [r7, #1]
.Le1404:
.balign 4
.hword (.Le1405 - .Lb1405) / 2, 0
.Lb1405:
ldr.w r5, [r7, #2]
.Le1405:
.balign 4
.hword (.Le1406 - .Lb1406) / 2, 0
.Lb1406:
ldr.w r11, [r7, #4]
.Le1406:
.balign 4
.hword (.Le1407 - .Lb1407) / 2, 0
.Lb1407:
ldr.w r11, [r7, #31]
.Le1407:
.balign 4
.hword (.Le1408 - .Lb1408) / 2, 0
.Lb1408:
ldr.w lr, [r7, #60]
.Le1408:
.balign 4
.hword (.Le1409 - .Lb1409) / 2, 0
.Lb1409:
ldr r9, [r7, #-1]
.Le1409:
.balign 4
.hword (.Le1410 - .Lb1410) / 2, 0
.Lb1410:
ldr r12, [r7, #-4]
.Le1410:
.balign 4
.hword (.Le1411 - .Lb1411) / 2, 0
.Lb1411:
ldr lr, [r7, #-13]
.Le1411:
.balign 4
.hword (.Le1412 - .Lb1412) / 2, 0
.Lb1412:
ldr r3, [r7, #-32]
.Le1412:
.balign 4
.hword (.Le1413 - .Lb1413) / 2, 0
.Lb1413:
ldrb.w r12, [r7, #0]
.Le1413:
.balign 4
.hword (.Le1414 - .Lb1414) / 2, 0
.Lb1414:
ldrb.w r11, [r7, #1]
.Le1414:
.balign 4
.hword (.Le1415 - .Lb1415) / 2, 0
.Lb1415:
ldrb.w r0, [r7, #2]
.Le1415:
.balign 4
.hword (.Le1416 - .Lb1416) / 2, 0
.Lb1416:
ldrb.w r10, [r7, #4]
.Le1416:
.balign 4
.hword (.Le1417 - .Lb1417) / 2, 0
.Lb1417:
ldrb.w r9, [r7, #31]
.Le1417:
.balign 4
.hword (.Le1418 - .Lb1418) / 2, 0
.Lb1418:
ldrb.w r11, [r7, #60]
.Le1418:
.balign 4
.hword (.Le1419 - .Lb1419) / 2, 0
.Lb1419:
ldrb r11, [r7, #-1]
.Le1419:
.balign 4
.hword (.Le1420 - .Lb1420) / 2, 0
.Lb1420:
ldrb r0, [r7, #-4]
.Le1420:
.balign 4
.hword (.Le1421 - .Lb1421) / 2, 0
.Lb1421:
ldrb r3, [r7, #-13]
.Le1421:
.balign 4
.hword (.Le1422 - .Lb1422) / 2, 0
.Lb1422:
ldrb lr, [r7, #-32]
.Le1422:
.balign 4
.hword (.Le1423 - .Lb1423) / 2, 0
.Lb1423:
ldrh.w r12, [r7, #0]
.Le1423:
.balign 4
.hword (.Le1424 - .Lb1424) / 2, 0
.Lb1424:
ldrh.w r10, [r7, #1]
.Le1424:
.balign 4
.hword (.Le1425 - .Lb1425) / 2, 0
.Lb1425:
ldrh.w r5, [r7, #2]
.Le1425:
.balign 4
.hword (.Le1426 - .Lb1426) / 2, 0
.Lb1426:
ldrh.w r10, [r7, #4]
.Le1426:
.balign 4
.hword (.Le1427 - .Lb1427) / 2, 0
.Lb1427:
ldrh.w r9, [r7, #31]
.Le1427:
.balign 4
.hword (.Le1428 - .Lb1428) / 2, 0
.Lb1428:
ldrh.w r11, [r7, #60]
.Le1428:
.balign 4
.hword (.Le1429 - .Lb1429) / 2, 0
.Lb1429:
ldrh r11, [r7, #-1]
.Le1429:
.balign 4
.hword (.Le1430 - .Lb1430) / 2, 0
.Lb1430:
ldrh r9, [r7, #-4]
.Le1430:
.balign 4
.hword (.Le1431 - .Lb1431) / 2, 0
.Lb1431:
ldrh r0, [r7, #-13]
.Le1431:
.balign 4
.hword (.Le1432 - .Lb1432) / 2, 0
.Lb1432:
ldrh r0, [r7, #-32]
.Le1432:
.balign 4
.hword (.Le1433 - .Lb1433) / 2, 0
.Lb1433:
ldrsb.w r0, [r7, #0]
.Le1433:
.balign 4
.hword (.Le1434 - .Lb1434) / 2, 0
.Lb1434:
ldrsb.w r5, [r7, #1]
.Le1434:
.balign 4
.hword (.Le1435 - .Lb1435) / 2, 0
.Lb1435:
ldrsb.w lr, [r7, #2]
.Le1435:
.balign 4
.hword (.Le1436 - .Lb1436) / 2, 0
.Lb1436:
ldrsb.w r11, [r7, #4]
.Le1436:
.balign 4
.hword (.Le1437 - .Lb1437) / 2, 0
.Lb1437:
ldrsb.w r0, [r7, #31]
.Le1437:
.balign 4
.hword (.Le1438 - .Lb1438) / 2, 0
.Lb1438:
ldrsb.w r10, [r7, #60]
.Le1438:
.balign 4
.hword (.Le1439 - .Lb1439) / 2, 0
.Lb1439:
ldrsb r10, [r7, #-1]
.Le1439:
.balign 4
.hword (.Le1440 - .Lb1440) / 2, 0
.Lb1440:
ldrsb r3, [r7, #-4]
.Le1440:
.balign 4
.hword (.Le1441 - .Lb1441) / 2, 0
.Lb1441:
ldrsb r9, [r7, #-13]
.Le1441:
.balign 4
.hword (.Le1442 - .Lb1442) / 2, 0
.Lb1442:
ldrsb r0, [r7, #-32]
.Le1442:
.balign 4
.hword (.Le1443 - .Lb1443) / 2, 0
.Lb1443:
ldrsh.w r5, [r7, #0]
.Le1443:
.balign 4
.hword (.Le1444 - .Lb1444) / 2, 0
.Lb1444:
ldrsh.w r12, [r7, #1]
.Le1444:
.balign 4
.hword (.Le1445 - .Lb1445) / 2, 0
.Lb1445:
ldrsh.w r11, [r7, #2]
.Le1445:
.balign 4
.hword (.Le1446 - .Lb1446) / 2, 0
.Lb1446:
ldrsh.w r10, [r7, #4]
.Le1446:
.balign 4
.hword (.Le1447 - .Lb1447) / 2, 0
.Lb1447:
ldrsh.w lr, [r7, #31]
.Le1447:
.balign 4
.hword (.Le1448 - .Lb1448) / 2, 0
.Lb1448:
ldrsh.w r0, [r7, #60]
.Le1448:
.balign 4
.hword (.Le1449 - .Lb1449) / 2, 0
.Lb1449:
ldrsh r12, [r7, #-1]
.Le1449:
.balign 4
.hword (.Le1450 - .Lb1450) / 2, 0
.Lb1450:
ldrsh r3, [r7, #-4]
.Le1450:
.balign 4
.hword (.Le1451 - .Lb1451) / 2, 0
.Lb1451:
ldrsh r10, [r7, #-13]
.Le1451:
.balign 4
.hword (.Le1452 - .Lb1452) / 2, 0
.Lb1452:
ldrsh r12, [r7, #-32]
.Le1452:
.balign 4
.hword 0xffff, 0
.balign 4
group_store_imm:
.balign 4
.hword (.Le1453 - .Lb1453) / 2, 0
.Lb1453:
str.w r9, [r7, #0]
.Le1453:
.balign 4
.hword (.Le1454 - .Lb1454) / 2, 0
.Lb1454:
str.w r9, [r7, #1]
.Le1454:
.balign 4
.hword (.Le1455 - .Lb1455) / 2, 0
.Lb1455:
str.w r12, [r7, #2]
.Le1455:
.balign 4
.hword (.Le1456 - .Lb1456) / 2, 0
.Lb1456:
str.w r10, [r7, #4]
.Le1456:
.balign 4
.hword (.Le1457 - .Lb1457) / 2, 0
.Lb1457:
str.w r0, [r7, #31]
.Le1457:
.balign 4
.hword (.Le1458 - .Lb1458) / 2, 0
.Lb1458:
str.w r0, [r7, #60]
.Le1458:
.balign 4
.hword (.Le1459 - .Lb1459) / 2, 0
.Lb1459:
str r5, [r7, #-1]
.Le1459:
.balign 4
.hword (.Le1460 - .Lb1460) / 2, 0
.Lb1460:
str lr, [r7, #-4]
.Le1460:
.balign 4
.hword (.Le1461 - .Lb1461) / 2, 0
.Lb1461:
str r5, [r7, #-13]
.Le1461:
.balign 4
.hword (.Le1462 - .Lb1462) / 2, 0
.Lb1462:
str r11, [r7, #-32]
.Le1462:
.balign 4
.hword (.Le1463 - .Lb1463) / 2, 0
.Lb1463:
strb.w r3, [r7, #0]
.Le1463:
.balign 4
.hword (.Le1464 - .Lb1464) / 2, 0
.Lb1464:
strb.w r9, [r7, #1]
.Le1464:
.balign 4
.hword (.Le1465 - .Lb1465) / 2, 0
.Lb1465:
strb.w r5, [r7, #2]
.Le1465:
.balign 4
.hword (.Le1466 - .Lb1466) / 2, 0
.Lb1466:
strb.w r5, [r7, #4]
.Le1466:
.balign 4
.hword (.Le1467 - .Lb1467) / 2, 0
.Lb1467:
strb.w r12, [r7, #31]
.Le1467:
.balign 4
.hword (.Le1468 - .Lb1468) / 2, 0
.Lb1468:
strb.w r5, [r7, #60]
.Le1468:
.balign 4
.hword (.Le1469 - .Lb1469) / 2, 0
.Lb1469:
strb r11, [r7, #-1]
.Le1469:
.balign 4
.hword (.Le1470 - .Lb1470) / 2, 0
.Lb1470:
strb r9, [r7, #-4]
.Le1470:
.balign 4
.hword (.Le1471 - .Lb1471) / 2, 0
.Lb1471:
strb r5, [r7, #-13]
.Le1471:
.balign 4
.hword (.Le1472 - .Lb1472) / 2, 0
.Lb1472:
strb r5, [r7, #-32]
.Le1472:
.balign 4
.hword (.Le1473 - .Lb1473) / 2, 0
.Lb1473:
strh.w r3, [r7, #0]
.Le1473:
.balign 4
.hword (.Le1474 - .Lb1474) / 2, 0
.Lb1474:
strh.w r5, [r7, #1]
.Le1474:
.balign 4
.hword (.Le1475 - .Lb1475) / 2, 0
.Lb1475:
strh.w r0, [r7, #2]
.Le1475:
.balign 4
.hword (.Le1476 - .Lb1476) / 2, 0
.Lb1476:
strh.w r10, [r7, #4]
.Le1476:
.balign 4
.hword (.Le1477 - .Lb1477) / 2, 0
.Lb1477:
strh.w r10, [r7, #31]
.Le1477:
.balign 4
.hword (.Le1478 - .Lb1478) / 2, 0
.Lb1478:
strh.w r11, [r7, #60]
.Le1478:
.balign 4
.hword (.Le1479 - .Lb1479) / 2, 0
.Lb1479:
strh r0, [r7, #-1]
.Le1479:
.balign 4
.hword (.Le1480 - .Lb1480) / 2, 0
.Lb1480:
strh r5, [r7, #-4]
.Le1480:
.balign 4
.hword (.Le1481 - .Lb1481) / 2, 0
.Lb1481:
strh r0, [r7, #-13]
.Le1481:
.balign 4
.hword (.Le1482 - .Lb1482) / 2, 0
.Lb1482:
strh r3, [r7, #-32]
.Le1482:
.balign 4
.hword 0xffff, 0
.balign 4
group_load_index:
.balign 4
.hword (.Le1483 - .Lb1483) / 2, 0
.Lb1483:
ldr lr, [r7, #4]!
.Le1483:
.balign 4
.hword (.Le1484 - .Lb1484) / 2, 0
.Lb1484:
ldr r12, [r7, #-7]!
.Le1484:
.balign 4
.hword (.Le1485 - .Lb1485) / 2, 0
.Lb1485:
ldr r12, [r7], #9
.Le1485:
.balign 4
.hword (.Le1486 - .Lb1486) / 2, 0
.Lb1486:
ldr r10, [r7], #-4
.Le1486:
.balign 4
.hword (.Le1487 - .Lb1487) / 2, 0
.Lb1487:
ldrb r5, [r7, #4]!
.Le1487:
.balign 4
.hword (.Le1488 - .Lb1488) / 2, 0
.Lb1488:
ldrb r12, [r7, #-7]!
.Le1488:
.balign 4
.hword (.Le1489 - .Lb1489) / 2, 0
.Lb1489:
ldrb r12, [r7], #9
.Le1489:
.balign 4
.hword (.Le1490 - .Lb1490) / 2, 0
.Lb1490:
ldrb r11, [r7], #-4
.Le1490:
.balign 4
.hword (.Le1491 - .Lb1491) / 2, 0
.Lb1491:
ldrh lr, [r7, #4]!
.Le1491:
.balign 4
.hword (.Le1492 - .Lb1492) / 2, 0
.Lb1492:
ldrh r11, [r7, #-7]!
.Le1492:
.balign 4
.hword (.Le1493 - .Lb1493) / 2, 0
.Lb1493:
ldrh r10, [r7], #9
.Le1493:
.balign 4
.hword (.Le1494 - .Lb1494) / 2, 0
.Lb1494:
ldrh lr, [r7], #-4
.Le1494:
.balign 4
.hword (.Le1495 - .Lb1495) / 2, 0
.Lb1495:
ldrsb r5, [r7, #4]!
.Le1495:
.balign 4
.hword (.Le1496 - .Lb1496) / 2, 0
.Lb1496:
ldrsb r10, [r7, #-7]!
.Le1496:
.balign 4
.hword (.Le1497 - .Lb1497) / 2, 0
.Lb1497:
ldrsb r0, [r7], #9
.Le1497:
.balign 4
.hword (.Le1498 - .Lb1498) / 2, 0
.Lb1498:
ldrsb r10, [r7], #-4
.Le1498:
.balign 4
.hword (.Le1499 - .Lb1499) / 2, 0
.Lb1499:
ldrsh r9, [r7, #4]!
.Le1499:
.balign 4
.hword (.Le1500 - .Lb1500) / 2, 0
.Lb1500:
ldrsh r0, [r7, #-7]!
.Le1500:
.balign 4
.hword (.Le1501 - .Lb1501) / 2, 0
.Lb1501:
ldrsh lr, [r7], #9
.Le1501:
.balign 4
.hword (.Le1502 - .Lb1502) / 2, 0
.Lb1502:
ldrsh r0, [r7], #-4
.Le1502:
.balign 4
.hword 0xffff, 0
.balign 4
group_store_index:
.balign 4
.hword (.Le1503 - .Lb1503) / 2, 0
.Lb1503:
str r0, [r7, #4]!
.Le1503:
.balign 4
.hword (.Le1504 - .Lb1504) / 2, 0
.Lb1504:
str r3, [r7, #-7]!
.Le1504:
.balign 4
.hword (.Le1505 - .Lb1505) / 2, 0
.Lb1505:
str lr, [r7], #9
.Le1505:
.balign 4
.hword (.Le1506 - .Lb1506) / 2, 0
.Lb1506:
str r0, [r7], #-4
.Le1506:
.balign 4
.hword (.Le1507 - .Lb1507) / 2, 0
.Lb1507:
strb r9, [r7, #4]!
.Le1507:
.balign 4
.hword (.Le1508 - .Lb1508) / 2, 0
.Lb1508:
strb r5, [r7, #-7]!
.Le1508:
.balign 4
.hword (.Le1509 - .Lb1509) / 2, 0
.Lb1509:
strb r12, [r7], #9
.Le1509:
.balign 4
.hword (.Le1510 - .Lb1510) / 2, 0
.Lb1510:
strb r12, [r7], #-4
.Le1510:
.balign 4
.hword (.Le1511 - .Lb1511) / 2, 0
.Lb1511:
strh r9, [r7, #4]!
.Le1511:
.balign 4
.hword (.Le1512 - .Lb1512) / 2, 0
.Lb1512:
strh r10, [r7, #-7]!
.Le1512:
.balign 4
.hword (.Le1513 - .Lb1513) / 2, 0
.Lb1513:
strh r5, [r7], #9
.Le1513:
.balign 4
.hword (.Le1514 - .Lb1514) / 2, 0
.Lb1514:
strh r9, [r7], #-4
.Le1514:
.balign 4
.hword 0xffff, 0
.balign 4
group_load_reg:
.balign 4
.hword (.Le1515 - .Lb1515) / 2, 0
.Lb1515:
ldr.w r5, [r7, r8]
.Le1515:
.balign 4
.hword (.Le1516 - .Lb1516) / 2, 0
.Lb1516:
ldr.w r3, [r7, r8, lsl #1]
.Le1516:
.balign 4
.hword (.Le1517 - .Lb1517) / 2, 0
.Lb1517:
ldr.w r11, [r7, r8, lsl #2]
.Le1517:
.balign 4
.hword (.Le1518 - .Lb1518) / 2, 0
.Lb1518:
ldrb.w r11, [r7, r8]
.Le1518:
.balign 4
.hword (.Le1519 - .Lb1519) / 2, 0
.Lb1519:
ldrb.w r3, [r7, r8, lsl #1]
.Le1519:
.balign 4
.hword (.Le1520 - .Lb1520) / 2, 0
.Lb1520:
ldrb.w r3, [r7, r8, lsl #2]
.Le1520:
.balign 4
.hword (.Le1521 - .Lb1521) / 2, 0
.Lb1521:
ldrh.w r9, [r7, r8]
.Le1521:
.balign 4
.hword (.Le1522 - .Lb1522) / 2, 0
.Lb1522:
ldrh.w r9, [r7, r8, lsl #1]
.Le1522:
.balign 4
.hword (.Le1523 - .Lb1523) / 2, 0
.Lb1523:
ldrh.w r11, [r7, r8, lsl #2]
.Le1523:
.balign 4
.hword (.Le1524 - .Lb1524) / 2, 0
.Lb1524:
ldrsb.w lr, [r7, r8]
.Le1524:
.balign 4
.hword (.Le1525 - .Lb1525) / 2, 0
.Lb1525:
ldrsb.w r3, [r7, r8, lsl #1]
.Le1525:
.balign 4
.hword (.Le1526 - .Lb1526) / 2, 0
.Lb1526:
ldrsb.w r12, [r7, r8, lsl #2]
.Le1526:
.balign 4
.hword (.Le1527 - .Lb1527) / 2, 0
.Lb1527:
ldrsh.w r11, [r7, r8]
.Le1527:
.balign 4
.hword (.Le1528 - .Lb1528) / 2, 0
.Lb1528:
ldrsh.w r5, [r7, r8, lsl #1]
.Le1528:
.balign 4
.hword (.Le1529 - .Lb1529) / 2, 0
.Lb1529:
ldrsh.w r5, [r7, r8, lsl #2]
.Le1529:
.balign 4
.hword 0xffff, 0
.balign 4
group_store_reg:
.balign 4
.hword (.Le1530 - .Lb1530) / 2, 0
.Lb1530:
str.w r3, [r7, r8]
.Le1530:
.balign 4
.hword (.Le1531 - .Lb1531) / 2, 0
.Lb1531:
str.w r11, [r7, r8, lsl #1]
.Le1531:
.balign 4
.hword (.Le1532 - .Lb1532) / 2, 0
.Lb1532:
str.w r5, [r7, r8, lsl #2]
.Le1532:
.balign 4
.hword (.Le1533 - .Lb1533) / 2, 0
.Lb1533:
strb.w lr, [r7, r8]
.Le1533:
.balign 4
.hword (.Le1534 - .Lb1534) / 2, 0
.Lb1534:
strb.w r3, [r7, r8, lsl #1]
.Le1534:
.balign 4
.hword (.Le1535 - .Lb1535) / 2, 0
.Lb1535:
strb.w lr, [r7, r8, lsl #2]
.Le1535:
.balign 4
.hword (.Le1536 - .Lb1536) / 2, 0
.Lb1536:
strh.w r12, [r7, r8]
.Le1536:
.balign 4
.hword (.Le1537 - .Lb1537) / 2, 0
.Lb1537:
strh.w r9, [r7, r8, lsl #1]
.Le1537:
.balign 4
.hword (.Le1538 - .Lb1538) / 2, 0
.Lb1538:
strh.w r3, [r7, r8, lsl #2]
.Le1538:
.balign 4
.hword 0xffff, 0
.balign 4
group_narrow_memory:
.balign 4
.hword (.Le1539 - .Lb1539) / 2, 0
.Lb1539:
ldr r1, [r7, #0]
.Le1539:
.balign 4
.hword (.Le1540 - .Lb1540) / 2, 0
.Lb1540:
ldr r1, [r7, #4]
.Le1540:
.balign 4
.hword (.Le1541 - .Lb1541) / 2, 0
.Lb1541:
ldr r1, [r7, #60]
.Le1541:
.balign 4
.hword (.Le1542 - .Lb1542) / 2, 0
.Lb1542:
ldrh r1, [r7, #0]
.Le1542:
.balign 4
.hword (.Le1543 - .Lb1543) / 2, 0
.Lb1543:
ldrh r1, [r7, #2]
.Le1543:
.balign 4
.hword (.Le1544 - .Lb1544) / 2, 0
.Lb1544:
ldrh r1, [r7, #30]
.Le1544:
.balign 4
.hword (.Le1545 - .Lb1545) / 2, 0
.Lb1545:
ldrb r1, [r7, #0]
.Le1545:
.balign 4
.hword (.Le1546 - .Lb1546) / 2, 0
.Lb1546:
ldrb r1, [r7, #1]
.Le1546:
.balign 4
.hword (.Le1547 - .Lb1547) / 2, 0
.Lb1547:
ldrb r1, [r7, #15]
.Le1547:
.balign 4
.hword (.Le1548 - .Lb1548) / 2, 0
.Lb1548:
str r1, [r7, #0]
.Le1548:
.balign 4
.hword (.Le1549 - .Lb1549) / 2, 0
.Lb1549:
str r1, [r7, #4]
.Le1549:
.balign 4
.hword (.Le1550 - .Lb1550) / 2, 0
.Lb1550:
str r1, [r7, #60]
.Le1550:
.balign 4
.hword (.Le1551 - .Lb1551) / 2, 0
.Lb1551:
strh r1, [r7, #0]
.Le1551:
.balign 4
.hword (.Le1552 - .Lb1552) / 2, 0
.Lb1552:
strh r1, [r7, #2]
.Le1552:
.balign 4
.hword (.Le1553 - .Lb1553) / 2, 0
.Lb1553:
strh r1, [r7, #30]
.Le1553:
.balign 4
.hword (.Le1554 - .Lb1554) / 2, 0
.Lb1554:
strb r1, [r7, #0]
.Le1554:
.balign 4
.hword (.Le1555 - .Lb1555) / 2, 0
.Lb1555:
strb r1, [r7, #1]
.Le1555:
.balign 4
.hword (.Le1556 - .Lb1556) / 2, 0
.Lb1556:
strb r1, [r7, #15]
.Le1556:
.balign 4
.hword (.Le1557 - .Lb1557) / 2, 0
.Lb1557:
mov r6, r8
ldr r2, [r7, r6]
.Le1557:
.balign 4
.hword (.Le1558 - .Lb1558) / 2, 0
.Lb1558:
mov r6, r8
ldrh r2, [r7, r6]
.Le1558:
.balign 4
.hword (.Le1559 - .Lb1559) / 2, 0
.Lb1559:
mov r6, r8
ldrb r2, [r7, r6]
.Le1559:
.balign 4
.hword (.Le1560 - .Lb1560) / 2, 0
.Lb1560:
mov r6, r8
ldrsh r2, [r7, r6]
.Le1560:
.balign 4
.hword (.Le1561 - .Lb1561) / 2, 0
.Lb1561:
mov r6, r8
ldrsb r2, [r7, r6]
.Le1561:
.balign 4
.hword (.Le1562 - .Lb1562) / 2, 0
.Lb1562:
mov r6, r8
str r2, [r7, r6]
.Le1562:
.balign 4
.hword (.Le1563 - .Lb1563) / 2, 0
.Lb1563:
mov r6, r8
strh r2, [r7, r6]
.Le1563:
.balign 4
.hword (.Le1564 - .Lb1564) / 2, 0
.Lb1564:
mov r6, r8
strb r2, [r7, r6]
.Le1564:
.balign 4
.hword (.Le1565 - .Lb1565) / 2, 0
.Lb1565:
str r3, [sp, #-64]
sub sp, #64
ldr r0, [sp, #0]
add sp, #64
.Le1565:
.balign 4
.hword (.Le1566 - .Lb1566) / 2, 0
.Lb1566:
sub sp, #8
str r4, [sp, #4]
ldr r2, [sp, #4]
add sp, #8
.Le1566:
.balign 4
.hword 0xffff, 0
.balign 4
group_literal:
.balign 4
.hword (.Le1567 - .Lb1567) / 2, 0
.Lb1567:
ldr r0, 1f
b 2f
.balign 4
1: .word 0x12345678
2: nop
.Le1567:
.balign 4
.hword (.Le1568 - .Lb1568) / 2, 0
.Lb1568:
ldr.w r9, 1f
b 2f
.balign 4
1: .word 0x9abcdef0
2: nop
.Le1568:
.balign 4
.hword (.Le1569 - .Lb1569) / 2, 0
.Lb1569:
ldrb.w r9, 1f
b 2f
.balign 4
1: .word 0x9abcdef0
2: nop
.Le1569:
.balign 4
.hword (.Le1570 - .Lb1570) / 2, 0
.Lb1570:
ldrsh.w r3, 1f
b 2f
.balign 4
1: .word 0x9abcdef0
2: nop
.Le1570:
.balign 4
.hword (.Le1571 - .Lb1571) / 2, 0
.Lb1571:
nop
ldr r1, 1f
b 2f
.balign 4
1: .word 0x0badcafe
2: nop
.Le1571:
.balign 4
.hword (.Le1572 - .Lb1572) / 2, 0
.Lb1572:
ldrd r2, r3, 1f
b 2f
.balign 4
1: .word 0x11223344, 0x55667788
2: nop
.Le1572:
.balign 4
.hword (.Le1573 - .Lb1573) / 2, 0
.Lb1573:
vldr s4, 1f
b 2f
.balign 4
1: .word 0x3f800001
2: nop
.Le1573:
.balign 4
.hword (.Le1574 - .Lb1574) / 2, 0
.Lb1574:
nop
vldr d4, 1f
b 2f
.balign 4
1: .word 0x3f800001, 0x40490fdb
2: nop
.Le1574:
.balign 4
.hword 0xffff, 0
.balign 4
group_dual:
.balign 4
.hword (.Le1575 - .Lb1575) / 2, 0
.Lb1575:
ldrd r0, r1, [r7]
.Le1575:
.balign 4
.hword (.Le1576 - .Lb1576) / 2, 0
.Lb1576:
ldrd r0, r1, [r7, #8]
.Le1576:
.balign 4
.hword (.Le1577 - .Lb1577) / 2, 0
.Lb1577:
ldrd r0, r1, [r7, #-16]
.Le1577:
.balign 4
.hword (.Le1578 - .Lb1578) / 2, 0
.Lb1578:
ldrd r0, r1, [r7, #4]!
.Le1578:
.balign 4
.hword (.Le1579 - .Lb1579) / 2, 0
.Lb1579:
ldrd r0, r1, [r7, #-4]!
.Le1579:
.balign 4
.hword (.Le1580 - .Lb1580) / 2, 0
.Lb1580:
ldrd r0, r1, [r7], #12
.Le1580:
.balign 4
.hword (.Le1581 - .Lb1581) / 2, 0
.Lb1581:
ldrd r0, r1, [r7], #-8
.Le1581:
.balign 4
.hword (.Le1582 - .Lb1582) / 2, 0
.Lb1582:
ldrd r5, r3, [r7]
.Le1582:
.balign 4
.hword (.Le1583 - .Lb1583) / 2, 0
.Lb1583:
ldrd r5, r3, [r7, #8]
.Le1583:
.balign 4
.hword (.Le1584 - .Lb1584) / 2, 0
.Lb1584:
ldrd r5, r3, [r7, #-16]
.Le1584:
.balign 4
.hword (.Le1585 - .Lb1585) / 2, 0
.Lb1585:
ldrd r5, r3, [r7, #4]!
.Le1585:
.balign 4
.hword (.Le1586 - .Lb1586) / 2, 0
.Lb1586:
ldrd r5, r3, [r7, #-4]!
.Le1586:
.balign 4
.hword (.Le1587 - .Lb1587) / 2, 0
.Lb1587:
ldrd r5, r3, [r7], #12
.Le1587:
.balign 4
.hword (.Le1588 - .Lb1588) / 2, 0
.Lb1588:
ldrd r5, r3, [r7], #-8
.Le1588:
.balign 4
.hword (.Le1589 - .Lb1589) / 2, 0
.Lb1589:
ldrd r9, r12, [r7]
.Le1589:
.balign 4
.hword (.Le1590 - .Lb1590) / 2, 0
.Lb1590:
ldrd r9, r12, [r7, #8]
.Le1590:
.balign 4
.hword (.Le1591 - .Lb1591) / 2, 0
.Lb1591:
ldrd r9, r12, [r7, #-16]
.Le1591:
.balign 4
.hword (.Le1592 - .Lb1592) / 2, 0
.Lb1592:
ldrd r9, r12, [r7, #4]!
.Le1592:
.balign 4
.hword (.Le1593 - .Lb1593) / 2, 0
.Lb1593:
ldrd r9, r12, [r7, #-4]!
.Le1593:
.balign 4
.hword (.Le1594 - .Lb1594) / 2, 0
.Lb1594:
ldrd r9, r12, [r7], #12
.Le1594:
.balign 4
.hword (.Le1595 - .Lb1595) / 2, 0
.Lb1595:
ldrd r9, r12, [r7], #-8
.Le1595:
.balign 4
.hword (.Le1596 - .Lb1596) / 2, 0
.Lb1596:
strd r0, r1, [r7]
.Le1596:
.balign 4
.hword (.Le1597 - .Lb1597) / 2, 0
.Lb1597:
strd r0, r1, [r7, #8]
.Le1597:
.balign 4
.hword (.Le1598 - .Lb1598) / 2, 0
.Lb1598:
strd r0, r1, [r7, #-16]
.Le1598:
.balign 4
.hword (.Le1599 - .Lb1599) / 2, 0
.Lb1599:
strd r0, r1, [r7, #4]!
.Le1599:
.balign 4
.hword (.Le1600 - .Lb1600) / 2, 0
.Lb1600:
strd r0, r1, [r7, #-4]!
.Le1600:
.balign 4
.hword (.Le1601 - .Lb1601) / 2, 0
.Lb1601:
strd r0, r1, [r7], #12
.Le1601:
.balign 4
.hword (.Le1602 - .Lb1602) / 2, 0
.Lb1602:
strd r0, r1, [r7], #-8
.Le1602:
.balign 4
.hword (.Le1603 - .Lb1603) / 2, 0
.Lb1603:
strd r5, r3, [r7]
.Le1603:
.balign 4
.hword (.Le1604 - .Lb1604) / 2, 0
.Lb1604:
strd r5, r3, [r7, #8]
.Le1604:
.balign 4
.hword (.Le1605 - .Lb1605) / 2, 0
.Lb1605:
strd r5, r3, [r7, #-16]
.Le1605:
.balign 4
.hword (.Le1606 - .Lb1606) / 2, 0
.Lb1606:
strd r5, r3, [r7, #4]!
.Le1606:
.balign 4
.hword (.Le1607 - .Lb1607) / 2, 0
.Lb1607:
strd r5, r3, [r7, #-4]!
.Le1607:
.balign 4
.hword (.Le1608 - .Lb1608) / 2, 0
.Lb1608:
strd r5, r3, [r7], #12
.Le1608:
.balign 4
.hword (.Le1609 - .Lb1609) / 2, 0
.Lb1609:
strd r5, r3, [r7], #-8
.Le1609:
.balign 4
.hword (.Le1610 - .Lb1610) / 2, 0
.Lb1610:
strd r9, r12, [r7]
.Le1610:
.balign 4
.hword (.Le1611 - .Lb1611) / 2, 0
.Lb1611:
strd r9, r12, [r7, #8]
.Le1611:
.balign 4
.hword (.Le1612 - .Lb1612) / 2, 0
.Lb1612:
strd r9, r12, [r7, #-16]
.Le1612:
.balign 4
.hword (.Le1613 - .Lb1613) / 2, 0
.Lb1613:
strd r9, r12, [r7, #4]!
.Le1613:
.balign 4
.hword (.Le1614 - .Lb1614) / 2, 0
.Lb1614:
strd r9, r12, [r7, #-4]!
.Le1614:
.balign 4
.hword (.Le1615 - .Lb1615) / 2, 0
.Lb1615:
strd r9, r12, [r7], #12
.Le1615:
.balign 4
.hword (.Le1616 - .Lb1616) / 2, 0
.Lb1616:
strd r9, r12, [r7], #-8
.Le1616:
.balign 4
.hword 0xffff, 0
.balign 4
group_multiple:
.balign 4
.hword (.Le1617 - .Lb1617) / 2, 0
.Lb1617:
ldmia.w r7, {r0, r1}
.Le1617:
.balign 4
.hword (.Le1618 - .Lb1618) / 2, 0
.Lb1618:
ldmia.w r7, {r2, r3, r4}
.Le1618:
.balign 4
.hword (.Le1619 - .Lb1619) / 2, 0
.Lb1619:
ldmia.w r7, {r0, r5, r9, r12}
.Le1619:
.balign 4
.hword (.Le1620 - .Lb1620) / 2, 0
.Lb1620:
ldmia.w r7, {r0-r6}
.Le1620:
.balign 4
.hword (.Le1621 - .Lb1621) / 2, 0
.Lb1621:
ldmia.w r7, {r1, r10, r11, lr}
.Le1621:
.balign 4
.hword (.Le1622 - .Lb1622) / 2, 0
.Lb1622:
ldmia.w r7!, {r0, r1}
.Le1622:
.balign 4
.hword (.Le1623 - .Lb1623) / 2, 0
.Lb1623:
ldmia.w r7!, {r2, r3, r4}
.Le1623:
.balign 4
.hword (.Le1624 - .Lb1624) / 2, 0
.Lb1624:
ldmia.w r7!, {r0, r5, r9, r12}
.Le1624:
.balign 4
.hword (.Le1625 - .Lb1625) / 2, 0
.Lb1625:
ldmia.w r7!, {r0-r6}
.Le1625:
.balign 4
.hword (.Le1626 - .Lb1626) / 2, 0
.Lb1626:
ldmia.w r7!, {r1, r10, r11, lr}
.Le1626:
.balign 4
.hword (.Le1627 - .Lb1627) / 2, 0
.Lb1627:
ldmdb.w r7, {r0, r1}
.Le1627:
.balign 4
.hword (.Le1628 - .Lb1628) / 2, 0
.Lb1628:
ldmdb.w r7, {r2, r3, r4}
.Le1628:
.balign 4
.hword (.Le1629 - .Lb1629) / 2, 0
.Lb1629:
ldmdb.w r7, {r0, r5, r9, r12}
.Le1629:
.balign 4
.hword (.Le1630 - .Lb1630) / 2, 0
.Lb1630:
ldmdb.w r7, {r0-r6}
.Le1630:
.balign 4
.hword (.Le1631 - .Lb1631) / 2, 0
.Lb1631:
ldmdb.w r7, {r1, r10, r11, lr}
.Le1631:
.balign 4
.hword (.Le1632 - .Lb1632) / 2, 0
.Lb1632:
ldmdb.w r7!, {r0, r1}
.Le1632:
.balign 4
.hword (.Le1633 - .Lb1633) / 2, 0
.Lb1633:
ldmdb.w r7!, {r2, r3, r4}
.Le1633:
.balign 4
.hword (.Le1634 - .Lb1634) / 2, 0
.Lb1634:
ldmdb.w r7!, {r0, r5, r9, r12}
.Le1634:
.balign 4
.hword (.Le1635 - .Lb1635) / 2, 0
.Lb1635:
ldmdb.w r7!, {r0-r6}
.Le1635:
.balign 4
.hword (.Le1636 - .Lb1636) / 2, 0
.Lb1636:
ldmdb.w r7!, {r1, r10, r11, lr}
.Le1636:
.balign 4
.hword (.Le1637 - .Lb1637) / 2, 0
.Lb1637:
stmia.w r7, {r0, r1}
.Le1637:
.balign 4
.hword (.Le1638 - .Lb1638) / 2, 0
.Lb1638:
stmia.w r7, {r2, r3, r4}
.Le1638:
.balign 4
.hword (.Le1639 - .Lb1639) / 2, 0
.Lb1639:
stmia.w r7, {r0, r5, r9, r12}
.Le1639:
.balign 4
.hword (.Le1640 - .Lb1640) / 2, 0
.Lb1640:
stmia.w r7, {r0-r6}
.Le1640:
.balign 4
.hword (.Le1641 - .Lb1641) / 2, 0
.Lb1641:
stmia.w r7, {r1, r10, r11, lr}
.Le1641:
.balign 4
.hword (.Le1642 - .Lb1642) / 2, 0
.Lb1642:
stmia.w r7!, {r0, r1}
.Le1642:
.balign 4
.hword (.Le1643 - .Lb1643) / 2, 0
.Lb1643:
stmia.w r7!, {r2, r3, r4}
.Le1643:
.balign 4
.hword (.Le1644 - .Lb1644) / 2, 0
.Lb1644:
stmia.w r7!, {r0, r5, r9, r12}
.Le1644:
.balign 4
.hword (.Le1645 - .Lb1645) / 2, 0
.Lb1645:
stmia.w r7!, {r0-r6}
.Le1645:
.balign 4
.hword (.Le1646 - .Lb1646) / 2, 0
.Lb1646:
stmia.w r7!, {r1, r10, r11, lr}
.Le1646:
.balign 4
.hword (.Le1647 - .Lb1647) / 2, 0
.Lb1647:
stmdb.w r7, {r0, r1}
.Le1647:
.balign 4
.hword (.Le1648 - .Lb1648) / 2, 0
.Lb1648:
stmdb.w r7, {r2, r3, r4}
.Le1648:
.balign 4
.hword (.Le1649 - .Lb1649) / 2, 0
.Lb1649:
stmdb.w r7, {r0, r5, r9, r12}
.Le1649:
.balign 4
.hword (.Le1650 - .Lb1650) / 2, 0
.Lb1650:
stmdb.w r7, {r0-r6}
.Le1650:
.balign 4
.hword (.Le1651 - .Lb1651) / 2, 0
.Lb1651:
stmdb.w r7, {r1, r10, r11, lr}
.Le1651:
.balign 4
.hword (.Le1652 - .Lb1652) / 2, 0
.Lb1652:
stmdb.w r7!, {r0, r1}
.Le1652:
.balign 4
.hword (.Le1653 - .Lb1653) / 2, 0
.Lb1653:
stmdb.w r7!, {r2, r3, r4}
.Le1653:
.balign 4
.hword (.Le1654 - .Lb1654) / 2, 0
.Lb1654:
stmdb.w r7!, {r0, r5, r9, r12}
.Le1654:
.balign 4
.hword (.Le1655 - .Lb1655) / 2, 0
.Lb1655:
stmdb.w r7!, {r0-r6}
.Le1655:
.balign 4
.hword (.Le1656 - .Lb1656) / 2, 0
.Lb1656:
stmdb.w r7!, {r1, r10, r11, lr}
.Le1656:
.balign 4
.hword (.Le1657 - .Lb1657) / 2, 0
.Lb1657:
ldmia r7!, {r0, r1, r2}
.Le1657:
.balign 4
.hword (.Le1658 - .Lb1658) / 2, 0
.Lb1658:
stmia r7!, {r0, r1, r2}
.Le1658:
.balign 4
.hword (.Le1659 - .Lb1659) / 2, 0
.Lb1659:
ldmia r7, {r0, r7}
.Le1659:
.balign 4
.hword (.Le1660 - .Lb1660) / 2, 0
.Lb1660:
push {r0, r3, lr}
pop {r1, r2, r3}
.Le1660:
.balign 4
.hword (.Le1661 - .Lb1661) / 2, 0
.Lb1661:
push.w {r0, r9, r12}
pop.w {r1, r10, r11}
.Le1661:
.balign 4
.hword (.Le1662 - .Lb1662) / 2, 0
.Lb1662:
push {r5}
pop {r6}
.Le1662:
.balign 4
.hword (.Le1663 - .Lb1663) / 2, 0
.Lb1663:
adr r0, 1f
adds r0, #1
push {r0, r1}
pop {r0, r1}
push {r0}
pop {pc}
.balign 4
1: nop
.Le1663:
.balign 4
.hword 0xffff, 0
.balign 4
group_exclusive:
.balign 4
.hword (.Le1664 - .Lb1664) / 2, 0
.Lb1664:
ldrex r0, [r7]
strex r1, r2, [r7]
.Le1664:
.balign 4
.hword (.Le1665 - .Lb1665) / 2, 0
.Lb1665:
ldrex r0, [r7, #8]
strex r1, r2, [r7, #8]
.Le1665:
.balign 4
.hword (.Le1666 - .Lb1666) / 2, 0
.Lb1666:
ldrexb r0, [r7]
strexb r1, r2, [r7]
.Le1666:
.balign 4
.hword (.Le1667 - .Lb1667) / 2, 0
.Lb1667:
ldrexh r0, [r7]
strexh r1, r2, [r7]
.Le1667:
.balign 4
.hword (.Le1668 - .Lb1668) / 2, 0
.Lb1668:
clrex
strex r1, r2, [r7]
.Le1668:
.balign 4
.hword (.Le1669 - .Lb1669) / 2, 0
.Lb1669:
ldrex r0, [r7]
clrex
strex r1, r2, [r7]
.Le1669:
.balign 4
.hword (.Le1670 - .Lb1670) / 2, 0
.Lb1670:
ldrex r0, [r7]
strex r1, r2, [r7]
strex r3, r4, [r7]
.Le1670:
.balign 4
.hword 0xffff, 0
.balign 4
group_hints:
.balign 4
.hword (.Le1671 - .Lb1671) / 2, 0
.Lb1671:
nop
.Le1671:
.balign 4
.hword (.Le1672 - .Lb1672) / 2, 0
.Lb1672:
nop.w
.Le1672:
.balign 4
.hword (.Le1673 - .Lb1673) / 2, 0
.Lb1673:
yield
.Le1673:
.balign 4
.hword (.Le1674 - .Lb1674) / 2, 0
.Lb1674:
sev
wfe
.Le1674:
.balign 4
.hword (.Le1675 - .Lb1675) / 2, 0
.Lb1675:
dmb
.Le1675:
.balign 4
.hword (.Le1676 - .Lb1676) / 2, 0
.Lb1676:
dsb
.Le1676:
.balign 4
.hword (.Le1677 - .Lb1677) / 2, 0
.Lb1677:
isb
.Le1677:
.balign 4
.hword (.Le1678 - .Lb1678) / 2, 0
.Lb1678:
pld [r7]
.Le1678:
.balign 4
.hword (.Le1679 - .Lb1679) / 2, 0
.Lb1679:
pld [r7, #-4]
.Le1679:
.balign 4
.hword (.Le1680 - .Lb1680) / 2, 0
.Lb1680:
pli [r7]
.Le1680:
.balign 4
.hword (.Le1681 - .Lb1681) / 2, 0
.Lb1681:
dbg #1
.Le1681:
.balign 4
.hword 0xffff, 0
.balign 4
group_special:
.balign 4
.hword (.Le1682 - .Lb1682) / 2, 0
.Lb1682:
mrs r0, apsr
.Le1682:
.balign 4
.hword (.Le1683 - .Lb1683) / 2, 0
.Lb1683:
msr apsr_nzcvq, r1
.Le1683:
.balign 4
.hword (.Le1684 - .Lb1684) / 2, 0
.Lb1684:
msr apsr_g, r1
.Le1684:
.balign 4
.hword (.Le1685 - .Lb1685) / 2, 0
.Lb1685:
msr apsr_nzcvqg, r1
.Le1685:
.balign 4
.hword (.Le1686 - .Lb1686) / 2, 0
.Lb1686:
msr basepri, r1
mrs r0, basepri
movs r2, #0
msr basepri, r2
and r0, r0, #0xf0
.Le1686:
.balign 4
.hword (.Le1687 - .Lb1687) / 2, 0
.Lb1687:
movs r0, #1
msr primask, r0
mrs r1, primask
cpsie i
mrs r2, primask
.Le1687:
.balign 4
.hword (.Le1688 - .Lb1688) / 2, 0
.Lb1688:
cpsid f
mrs r0, faultmask
cpsie f
mrs r1, faultmask
.Le1688:
.balign 4
.hword (.Le1689 - .Lb1689) / 2, 0
.Lb1689:
cpsid i
mrs r0, primask
cpsie i
.Le1689:
.balign 4
.hword (.Le1690 - .Lb1690) / 2, 0
.Lb1690:
mrs r0, ipsr
.Le1690:
.balign 4
.hword (.Le1691 - .Lb1691) / 2, 0
.Lb1691:
mrs r0, control
.Le1691:
.balign 4
.hword (.Le1692 - .Lb1692) / 2, 0
.Lb1692:
mrs r0, msp
.Le1692:
.balign 4
.hword (.Le1693 - .Lb1693) / 2, 0
.Lb1693:
mrs r0, xpsr
.Le1693:
.balign 4
.hword (.Le1694 - .Lb1694) / 2, 0
.Lb1694:
mrs r0, eapsr
.Le1694:
.balign 4
.hword (.Le1695 - .Lb1695) / 2, 0
.Lb1695:
movs r0, #0x80
msr basepri_max, r0
movs r1, #0xa0
msr basepri_max, r1
mrs r2, basepri
movs r1, #0x40
msr basepri_max, r1
mrs r3, basepri
movs r1, #0
msr basepri, r1
.Le1695:
.balign 4
.hword 0xffff, 0
.balign 4
group_vadd:
.balign 4
.hword (.Le1696 - .Lb1696) / 2, 0
.Lb1696:
vadd.f32 s4, s16, s21
.Le1696:
.balign 4
.hword (.Le1697 - .Lb1697) / 2, 0
.Lb1697:
vadd.f32 s25, s23, s20
.Le1697:
.balign 4
.hword (.Le1698 - .Lb1698) / 2, 0
.Lb1698:
vadd.f32 s27, s4, s12
.Le1698:
.balign 4
.hword (.Le1699 - .Lb1699) / 2, 0
.Lb1699:
vadd.f32 s26, s22, s31
.Le1699:
.balign 4
.hword (.Le1700 - .Lb1700) / 2, 0
.Lb1700:
vadd.f32 s22, s7, s28
.Le1700:
.balign 4
.hword (.Le1701 - .Lb1701) / 2, 0
.Lb1701:
vadd.f32 s21, s0, s14
.Le1701:
.balign 4
.hword (.Le1702 - .Lb1702) / 2, 0
.Lb1702:
vadd.f32 s19, s26, s8
.Le1702:
.balign 4
.hword (.Le1703 - .Lb1703) / 2, 0
.Lb1703:
vadd.f32 s12, s17, s2
.Le1703:
.balign 4
.hword (.Le1704 - .Lb1704) / 2, 0
.Lb1704:
vadd.f32 s10, s19, s3
.Le1704:
.balign 4
.hword (.Le1705 - .Lb1705) / 2, 0
.Lb1705:
vadd.f32 s7, s17, s7
.Le1705:
.balign 4
.hword (.Le1706 - .Lb1706) / 2, 0
.Lb1706:
vadd.f32 s11, s28, s15
.Le1706:
.balign 4
.hword (.Le1707 - .Lb1707) / 2, 0
.Lb1707:
vadd.f32 s29, s27, s3
.Le1707:
.balign 4
.hword (.Le1708 - .Lb1708) / 2, 0
.Lb1708:
vadd.f32 s9, s31, s23
.Le1708:
.balign 4
.hword (.Le1709 - .Lb1709) / 2, 0
.Lb1709:
vadd.f32 s18, s24, s5
.Le1709:
.balign 4
.hword (.Le1710 - .Lb1710) / 2, 0
.Lb1710:
vadd.f32 s27, s8, s14
.Le1710:
.balign 4
.hword (.Le1711 - .Lb1711) / 2, 0
.Lb1711:
vadd.f32 s27, s31, s4
.Le1711:
.balign 4
.hword (.Le1712 - .Lb1712) / 2, 0
.Lb1712:
vadd.f32 s23, s11, s3
.Le1712:
.balign 4
.hword (.Le1713 - .Lb1713) / 2, 0
.Lb1713:
vadd.f32 s13, s12, s1
.Le1713:
.balign 4
.hword (.Le1714 - .Lb1714) / 2, 0
.Lb1714:
vadd.f32 s22, s15, s15
.Le1714:
.balign 4
.hword (.Le1715 - .Lb1715) / 2, 0
.Lb1715:
vadd.f32 s26, s26, s10
.Le1715:
.balign 4
.hword (.Le1716 - .Lb1716) / 2, 0
.Lb1716:
vadd.f32 s15, s0, s14
.Le1716:
.balign 4
.hword (.Le1717 - .Lb1717) / 2, 0
.Lb1717:
vadd.f32 s3, s9, s5
.Le1717:
.balign 4
.hword (.Le1718 - .Lb1718) / 2, 0
.Lb1718:
vadd.f32 s1, s9, s17
.Le1718:
.balign 4
.hword (.Le1719 - .Lb1719) / 2, 0
.Lb1719:
vadd.f32 s14, s23, s21
.Le1719:
.balign 4
.hword 0xffff, 0
.balign 4
group_vsub:
.balign 4
.hword (.Le1720 - .Lb1720) / 2, 0
.Lb1720:
vsub.f32 s8, s6, s16
.Le1720:
.balign 4
.hword (.Le1721 - .Lb1721) / 2, 0
.Lb1721:
vsub.f32 s26, s22, s2
.Le1721:
.balign 4
.hword (.Le1722 - .Lb1722) / 2, 0
.Lb1722:
vsub.f32 s3, s29, s2
.Le1722:
.balign 4
.hword (.Le1723 - .Lb1723) / 2, 0
.Lb1723:
vsub.f32 s20, s19, s19
.Le1723:
.balign 4
.hword (.Le1724 - .Lb1724) / 2, 0
.Lb1724:
vsub.f32 s24, s19, s24
.Le1724:
.balign 4
.hword (.Le1725 - .Lb1725) / 2, 0
.Lb1725:
vsub.f32 s30, s18, s7
.Le1725:
.balign 4
.hword (.Le1726 - .Lb1726) / 2, 0
.Lb1726:
vsub.f32 s0, s6, s27
.Le1726:
.balign 4
.hword (.Le1727 - .Lb1727) / 2, 0
.Lb1727:
vsub.f32 s4, s13, s7
.Le1727:
.balign 4
.hword (.Le1728 - .Lb1728) / 2, 0
.Lb1728:
vsub.f32 s0, s15, s30
.Le1728:
.balign 4
.hword (.Le1729 - .Lb1729) / 2, 0
.Lb1729:
vsub.f32 s4, s13, s21
.Le1729:
.balign 4
.hword (.Le1730 - .Lb1730) / 2, 0
.Lb1730:
vsub.f32 s13, s18, s18
.Le1730:
.balign 4
.hword (.Le1731 - .Lb1731) / 2, 0
.Lb1731:
vsub.f32 s29, s29, s13
.Le1731:
.balign 4
.hword (.Le1732 - .Lb1732) / 2, 0
.Lb1732:
vsub.f32 s29, s24, s5
.Le1732:
.balign 4
.hword (.Le1733 - .Lb1733) / 2, 0
.Lb1733:
vsub.f32 s1, s4, s19
.Le1733:
.balign 4
.hword (.Le1734 - .Lb1734) / 2, 0
.Lb1734:
vsub.f32 s28, s13, s18
.Le1734:
.balign 4
.hword (.Le1735 - .Lb1735) / 2, 0
.Lb1735:
vsub.f32 s26, s11, s25
.Le1735:
.balign 4
.hword (.Le1736 - .Lb1736) / 2, 0
.Lb1736:
vsub.f32 s24, s29, s14
.Le1736:
.balign 4
.hword (.Le1737 - .Lb1737) / 2, 0
.Lb1737:
vsub.f32 s15, s31, s0
.Le1737:
.balign 4
.hword (.Le1738 - .Lb1738) / 2, 0
.Lb1738:
vsub.f32 s18, s17, s30
.Le1738:
.balign 4
.hword (.Le1739 - .Lb1739) / 2, 0
.Lb1739:
vsub.f32 s31, s22, s7
.Le1739:
.balign 4
.hword (.Le1740 - .Lb1740) / 2, 0
.Lb1740:
vsub.f32 s7, s13, s28
.Le1740:
.balign 4
.hword (.Le1741 - .Lb1741) / 2, 0
.Lb1741:
vsub.f32 s24, s13, s26
.Le1741:
.balign 4
.hword (.Le1742 - .Lb1742) / 2, 0
.Lb1742:
vsub.f32 s3, s11, s24
.Le1742:
.balign 4
.hword (.Le1743 - .Lb1743) / 2, 0
.Lb1743:
vsub.f32 s27, s23, s9
.Le1743:
.balign 4
.hword 0xffff, 0
.balign 4
group_vmul:
.balign 4
.hword (.Le1744 - .Lb1744) / 2, 0
.Lb1744:
vmul.f32 s4, s10, s2
.Le1744:
.balign 4
.hword (.Le1745 - .Lb1745) / 2, 0
.Lb1745:
vmul.f32 s13, s29, s19
.Le1745:
.balign 4
.hword (.Le1746 - .Lb1746) / 2, 0
.Lb1746:
vmul.f32 s19, s30, s8
.Le1746:
.balign 4
.hword (.Le1747 - .Lb1747) / 2, 0
.Lb1747:
vmul.f32 s1, s28, s27
.Le1747:
.balign 4
.hword (.Le1748 - .Lb1748) / 2, 0
.Lb1748:
vmul.f32 s22, s27, s23
.Le1748:
.balign 4
.hword (.Le1749 - .Lb1749) / 2, 0
.Lb1749:
vmul.f32 s13, s17, s13
.Le1749:
.balign 4
.hword (.Le1750 - .Lb1750) / 2, 0
.Lb1750:
vmul.f32 s29, s30, s17
.Le1750:
.balign 4
.hword (.Le1751 - .Lb1751) / 2, 0
.Lb1751:
vmul.f32 s26, s18, s17
.Le1751:
.balign 4
.hword (.Le1752 - .Lb1752) / 2, 0
.Lb1752:
vmul.f32 s28, s4, s7
.Le1752:
.balign 4
.hword (.Le1753 - .Lb1753) / 2, 0
.Lb1753:
vmul.f32 s20, s28, s18
.Le1753:
.balign 4
.hword (.Le1754 - .Lb1754) / 2, 0
.Lb1754:
vmul.f32 s14, s20, s15
.Le1754:
.balign 4
.hword (.Le1755 - .Lb1755) / 2, 0
.Lb1755:
vmul.f32 s9, s10, s16
.Le1755:
.balign 4
.hword (.Le1756 - .Lb1756) / 2, 0
.Lb1756:
vmul.f32 s15, s26, s1
.Le1756:
.balign 4
.hword (.Le1757 - .Lb1757) / 2, 0
.Lb1757:
vmul.f32 s27, s25, s14
.Le1757:
.balign 4
.hword (.Le1758 - .Lb1758) / 2, 0
.Lb1758:
vmul.f32 s8, s4, s5
.Le1758:
.balign 4
.hword (.Le1759 - .Lb1759) / 2, 0
.Lb1759:
vmul.f32 s10, s29, s24
.Le1759:
.balign 4
.hword (.Le1760 - .Lb1760) / 2, 0
.Lb1760:
vmul.f32 s14, s18, s25
.Le1760:
.balign 4
.hword (.Le1761 - .Lb1761) / 2, 0
.Lb1761:
vmul.f32 s17, s0, s18
.Le1761:
.balign 4
.hword (.Le1762 - .Lb1762) / 2, 0
.Lb1762:
vmul.f32 s9, s7, s27
.Le1762:
.balign 4
.hword (.Le1763 - .Lb1763) / 2, 0
.Lb1763:
vmul.f32 s18, s19, s26
.Le1763:
.balign 4
.hword (.Le1764 - .Lb1764) / 2, 0
.Lb1764:
vmul.f32 s3, s9, s6
.Le1764:
.balign 4
.hword (.Le1765 - .Lb1765) / 2, 0
.Lb1765:
vmul.f32 s10, s31, s27
.Le1765:
.balign 4
.hword (.Le1766 - .Lb1766) / 2, 0
.Lb1766:
vmul.f32 s7, s3, s22
.Le1766:
.balign 4
.hword (.Le1767 - .Lb1767) / 2, 0
.Lb1767:
vmul.f32 s20, s19, s2
.Le1767:
.balign 4
.hword 0xffff, 0
.balign 4
group_vnmul:
.balign 4
.hword (.Le1768 - .Lb1768) / 2, 0
.Lb1768:
vnmul.f32 s19, s28, s2
.Le1768:
.balign 4
.hword (.Le1769 - .Lb1769) / 2, 0
.Lb1769:
vnmul.f32 s22, s18, s13
.Le1769:
.balign 4
.hword (.Le1770 - .Lb1770) / 2, 0
.Lb1770:
vnmul.f32 s16, s17, s10
.Le1770:
.balign 4
.hword (.Le1771 - .Lb1771) / 2, 0
.Lb1771:
vnmul.f32 s18, s21, s5
.Le1771:
.balign 4
.hword (.Le1772 - .Lb1772) / 2, 0
.Lb1772:
vnmul.f32 s2, s8, s8
.Le1772:
.balign 4
.hword (.Le1773 - .Lb1773) / 2, 0
.Lb1773:
vnmul.f32 s24, s20, s21
.Le1773:
.balign 4
.hword (.Le1774 - .Lb1774) / 2, 0
.Lb1774:
vnmul.f32 s30, s10, s18
.Le1774:
.balign 4
.hword (.Le1775 - .Lb1775) / 2, 0
.Lb1775:
vnmul.f32 s1, s16, s1
.Le1775:
.balign 4
.hword (.Le1776 - .Lb1776) / 2, 0
.Lb1776:
vnmul.f32 s1, s26, s29
.Le1776:
.balign 4
.hword (.Le1777 - .Lb1777) / 2, 0
.Lb1777:
vnmul.f32 s1, s24, s6
.Le1777:
.balign 4
.hword (.Le1778 - .Lb1778) / 2, 0
.Lb1778:
vnmul.f32 s7, s1, s24
.Le1778:
.balign 4
.hword (.Le1779 - .Lb1779) / 2, 0
.Lb1779:
vnmul.f32 s5, s31, s13
.Le1779:
.balign 4
.hword (.Le1780 - .Lb1780) / 2, 0
.Lb1780:
vnmul.f32 s22, s2, s26
.Le1780:
.balign 4
.hword (.Le1781 - .Lb1781) / 2, 0
.Lb1781:
vnmul.f32 s30, s20, s12
.Le1781:
.balign 4
.hword (.Le1782 - .Lb1782) / 2, 0
.Lb1782:
vnmul.f32 s0, s8, s30
.Le1782:
.balign 4
.hword (.Le1783 - .Lb1783) / 2, 0
.Lb1783:
vnmul.f32 s30, s16, s27
.Le1783:
.balign 4
.hword (.Le1784 - .Lb1784) / 2, 0
.Lb1784:
vnmul.f32 s6, s26, s28
.Le1784:
.balign 4
.hword (.Le1785 - .Lb1785) / 2, 0
.Lb1785:
vnmul.f32 s18, s5, s3
.Le1785:
.balign 4
.hword (.Le1786 - .Lb1786) / 2, 0
.Lb1786:
vnmul.f32 s27, s9, s22
.Le1786:
.balign 4
.hword (.Le1787 - .Lb1787) / 2, 0
.Lb1787:
vnmul.f32 s12, s5, s29
.Le1787:
.balign 4
.hword (.Le1788 - .Lb1788) / 2, 0
.Lb1788:
vnmul.f32 s23, s7, s21
.Le1788:
.balign 4
.hword (.Le1789 - .Lb1789) / 2, 0
.Lb1789:
vnmul.f32 s6, s13, s20
.Le1789:
.balign 4
.hword (.Le1790 - .Lb1790) / 2, 0
.Lb1790:
vnmul.f32 s10, s10, s21
.Le1790:
.balign 4
.hword (.Le1791 - .Lb1791) / 2, 0
.Lb1791:
vnmul.f32 s5, s13, s18
.Le1791:
.balign 4
.hword 0xffff, 0
.balign 4
group_vdiv:
.balign 4
.hword (.Le1792 - .Lb1792) / 2, 0
.Lb1792:
vdiv.f32 s4, s31, s29
.Le1792:
.balign 4
.hword (.Le1793 - .Lb1793) / 2, 0
.Lb1793:
vdiv.f32 s28, s24, s23
.Le1793:
.balign 4
.hword (.Le1794 - .Lb1794) / 2, 0
.Lb1794:
vdiv.f32 s30, s11, s9
.Le1794:
.balign 4
.hword (.Le1795 - .Lb1795) / 2, 0
.Lb1795:
vdiv.f32 s0, s11, s19
.Le1795:
.balign 4
.hword (.Le1796 - .Lb1796) / 2, 0
.Lb1796:
vdiv.f32 s11, s9, s13
.Le1796:
.balign 4
.hword (.Le1797 - .Lb1797) / 2, 0
.Lb1797:
vdiv.f32 s8, s15, s29
.Le1797:
.balign 4
.hword (.Le1798 - .Lb1798) / 2, 0
.Lb1798:
vdiv.f32 s8, s5, s31
.Le1798:
.balign 4
.hword (.Le1799 - .Lb1799) / 2, 0
.Lb1799:
vdiv.f32 s24, s25, s27
.Le1799:
.balign 4
.hword (.Le1800 - .Lb1800) / 2, 0
.Lb1800:
vdiv.f32 s27, s30, s17
.Le1800:
.balign 4
.hword (.Le1801 - .Lb1801) / 2, 0
.Lb1801:
vdiv.f32 s30, s8, s12
.Le1801:
.balign 4
.hword (.Le1802 - .Lb1802) / 2, 0
.Lb1802:
vdiv.f32 s24, s2, s17
.Le1802:
.balign 4
.hword (.Le1803 - .Lb1803) / 2, 0
.Lb1803:
vdiv.f32 s8, s28, s13
.Le1803:
.balign 4
.hword (.Le1804 - .Lb1804) / 2, 0
.Lb1804:
vdiv.f32 s9, s24, s28
.Le1804:
.balign 4
.hword (.Le1805 - .Lb1805) / 2, 0
.Lb1805:
vdiv.f32 s3, s22, s14
.Le1805:
.balign 4
.hword (.Le1806 - .Lb1806) / 2, 0
.Lb1806:
vdiv.f32 s9, s18, s31
.Le1806:
.balign 4
.hword (.Le1807 - .Lb1807) / 2, 0
.Lb1807:
vdiv.f32 s21, s9, s4
.Le1807:
.balign 4
.hword (.Le1808 - .Lb1808) / 2, 0
.Lb1808:
vdiv.f32 s25, s4, s4
.Le1808:
.balign 4
.hword (.Le1809 - .Lb1809) / 2, 0
.Lb1809:
vdiv.f32 s0, s1, s4
.Le1809:
.balign 4
.hword (.Le1810 - .Lb1810) / 2, 0
.Lb1810:
vdiv.f32 s5, s8, s16
.Le1810:
.balign 4
.hword (.Le1811 - .Lb1811) / 2, 0
.Lb1811:
vdiv.f32 s3, s13, s27
.Le1811:
.balign 4
.hword (.Le1812 - .Lb1812) / 2, 0
.Lb1812:
vdiv.f32 s21, s17, s22
.Le1812:
.balign 4
.hword (.Le1813 - .Lb1813) / 2, 0
.Lb1813:
vdiv.f32 s12, s10, s26
.Le1813:
.balign 4
.hword (.Le1814 - .Lb1814) / 2, 0
.Lb1814:
vdiv.f32 s5, s22, s7
.Le1814:
.balign 4
.hword (.Le1815 - .Lb1815) / 2, 0
.Lb1815:
vdiv.f32 s27, s28, s21
.Le1815:
.balign 4
.hword 0xffff, 0
.balign 4
group_vmla:
.balign 4
.hword (.Le1816 - .Lb1816) / 2, 0
.Lb1816:
vmla.f32 s6, s0, s3
.Le1816:
.balign 4
.hword (.Le1817 - .Lb1817) / 2, 0
.Lb1817:
vmla.f32 s9, s26, s13
.Le1817:
.balign 4
.hword (.Le1818 - .Lb1818) / 2, 0
.Lb1818:
vmla.f32 s12, s4, s10
.Le1818:
.balign 4
.hword (.Le1819 - .Lb1819) / 2, 0
.Lb1819:
vmla.f32 s29, s1, s20
.Le1819:
.balign 4
.hword (.Le1820 - .Lb1820) / 2, 0
.Lb1820:
vmla.f32 s18, s19, s9
.Le1820:
.balign 4
.hword (.Le1821 - .Lb1821) / 2, 0
.Lb1821:
vmla.f32 s28, s3, s2
.Le1821:
.balign 4
.hword (.Le1822 - .Lb1822) / 2, 0
.Lb1822:
vmla.f32 s18, s10, s1
.Le1822:
.balign 4
.hword (.Le1823 - .Lb1823) / 2, 0
.Lb1823:
vmla.f32 s20, s1, s9
.Le1823:
.balign 4
.hword (.Le1824 - .Lb1824) / 2, 0
.Lb1824:
vmla.f32 s16, s6, s14
.Le1824:
.balign 4
.hword (.Le1825 - .Lb1825) / 2, 0
.Lb1825:
vmla.f32 s16, s31, s31
.Le1825:
.balign 4
.hword (.Le1826 - .Lb1826) / 2, 0
.Lb1826:
vmla.f32 s12, s4, s8
.Le1826:
.balign 4
.hword (.Le1827 - .Lb1827) / 2, 0
.Lb1827:
vmla.f32 s18, s1, s15
.Le1827:
.balign 4
.hword (.Le1828 - .Lb1828) / 2, 0
.Lb1828:
vmla.f32 s10, s11, s15
.Le1828:
.balign 4
.hword (.Le1829 - .Lb1829) / 2, 0
.Lb1829:
vmla.f32 s29, s6, s0
.Le1829:
.balign 4
.hword (.Le1830 - .Lb1830) / 2, 0
.Lb1830:
vmla.f32 s12, s23, s10
.Le1830:
.balign 4
.hword (.Le1831 - .Lb1831) / 2, 0
.Lb1831:
vmla.f32 s17, s6, s5
.Le1831:
.balign 4
.hword (.Le1832 - .Lb1832) / 2, 0
.Lb1832:
vmla.f32 s19, s14, s24
.Le1832:
.balign 4
.hword (.Le1833 - .Lb1833) / 2, 0
.Lb1833:
vmla.f32 s19, s8, s19
.Le1833:
.balign 4
.hword (.Le1834 - .Lb1834) / 2, 0
.Lb1834:
vmla.f32 s8, s19, s7
.Le1834:
.balign 4
.hword (.Le1835 - .Lb1835) / 2, 0
.Lb1835:
vmla.f32 s19, s6, s13
.Le1835:
.balign 4
.hword (.Le1836 - .Lb1836) / 2, 0
.Lb1836:
vmla.f32 s28, s25, s6
.Le1836:
.balign 4
.hword (.Le1837 - .Lb1837) / 2, 0
.Lb1837:
vmla.f32 s1, s25, s30
.Le1837:
.balign 4
.hword (.Le1838 - .Lb1838) / 2, 0
.Lb1838:
vmla.f32 s0, s18, s30
.Le1838:
.balign 4
.hword (.Le1839 - .Lb1839) / 2, 0
.Lb1839:
vmla.f32 s30, s23, s11
.Le1839:
.balign 4
.hword 0xffff, 0
.balign 4
group_vmls:
.balign 4
.hword (.Le1840 - .Lb1840) / 2, 0
.Lb1840:
vmls.f32 s13, s30, s12
.Le1840:
.balign 4
.hword (.Le1841 - .Lb1841) / 2, 0
.Lb1841:
vmls.f32 s14, s8, s27
.Le1841:
.balign 4
.hword (.Le1842 - .Lb1842) / 2, 0
.Lb1842:
vmls.f32 s12, s23, s31
.Le1842:
.balign 4
.hword (.Le1843 - .Lb1843) / 2, 0
.Lb1843:
vmls.f32 s14, s3, s15
.Le1843:
.balign 4
.hword (.Le1844 - .Lb1844) / 2, 0
.Lb1844:
vmls.f32 s7, s23, s4
.Le1844:
.balign 4
.hword (.Le1845 - .Lb1845) / 2, 0
.Lb1845:
vmls.f32 s2, s13, s27
.Le1845:
.balign 4
.hword (.Le1846 - .Lb1846) / 2, 0
.Lb1846:
vmls.f32 s21, s26, s28
.Le1846:
.balign 4
.hword (.Le1847 - .Lb1847) / 2, 0
.Lb1847:
vmls.f32 s28, s29, s28
.Le1847:
.balign 4
.hword (.Le1848 - .Lb1848) / 2, 0
.Lb1848:
vmls.f32 s23, s2, s13
.Le1848:
.balign 4
.hword (.Le1849 - .Lb1849) / 2, 0
.Lb1849:
vmls.f32 s16, s8, s6
.Le1849:
.balign 4
.hword (.Le1850 - .Lb1850) / 2, 0
.Lb1850:
vmls.f32 s26, s12, s20
.Le1850:
.balign 4
.hword (.Le1851 - .Lb1851) / 2, 0
.Lb1851:
vmls.f32 s6, s0, s14
.Le1851:
.balign 4
.hword (.Le1852 - .Lb1852) / 2, 0
.Lb1852:
vmls.f32 s12, s24, s12
.Le1852:
.balign 4
.hword (.Le1853 - .Lb1853) / 2, 0
.Lb1853:
vmls.f32 s19, s19, s23
.Le1853:
.balign 4
.hword (.Le1854 - .Lb1854) / 2, 0
.Lb1854:
vmls.f32 s14, s1, s15
.Le1854:
.balign 4
.hword (.Le1855 - .Lb1855) / 2, 0
.Lb1855:
vmls.f32 s17, s19, s11
.Le1855:
.balign 4
.hword (.Le1856 - .Lb1856) / 2, 0
.Lb1856:
vmls.f32 s7, s0, s22
.Le1856:
.balign 4
.hword (.Le1857 - .Lb1857) / 2, 0
.Lb1857:
vmls.f32 s9, s24, s31
.Le1857:
.balign 4
.hword (.Le1858 - .Lb1858) / 2, 0
.Lb1858:
vmls.f32 s29, s7, s14
.Le1858:
.balign 4
.hword (.Le1859 - .Lb1859) / 2, 0
.Lb1859:
vmls.f32 s22, s3, s5
.Le1859:
.balign 4
.hword (.Le1860 - .Lb1860) / 2, 0
.Lb1860:
vmls.f32 s15, s10, s12
.Le1860:
.balign 4
.hword (.Le1861 - .Lb1861) / 2, 0
.Lb1861:
vmls.f32 s27, s8, s24
.Le1861:
.balign 4
.hword (.Le1862 - .Lb1862) / 2, 0
.Lb1862:
vmls.f32 s25, s22, s5
.Le1862:
.balign 4
.hword (.Le1863 - .Lb1863) / 2, 0
.Lb1863:
vmls.f32 s2, s29, s22
.Le1863:
.balign 4
.hword 0xffff, 0
.balign 4
group_vnmla:
.balign 4
.hword (.Le1864 - .Lb1864) / 2, 0
.Lb1864:
vnmla.f32 s18, s23, s21
.Le1864:
.balign 4
.hword (.Le1865 - .Lb1865) / 2, 0
.Lb1865:
vnmla.f32 s23, s0, s7
.Le1865:
.balign 4
.hword (.Le1866 - .Lb1866) / 2, 0
.Lb1866:
vnmla.f32 s24, s19, s17
.Le1866:
.balign 4
.hword (.Le1867 - .Lb1867) / 2, 0
.Lb1867:
vnmla.f32 s3, s30, s17
.Le1867:
.balign 4
.hword (.Le1868 - .Lb1868) / 2, 0
.Lb1868:
vnmla.f32 s3, s31, s20
.Le1868:
.balign 4
.hword (.Le1869 - .Lb1869) / 2, 0
.Lb1869:
vnmla.f32 s27, s29, s14
.Le1869:
.balign 4
.hword (.Le1870 - .Lb1870) / 2, 0
.Lb1870:
vnmla.f32 s10, s2, s25
.Le1870:
.balign 4
.hword (.Le1871 - .Lb1871) / 2, 0
.Lb1871:
vnmla.f32 s16, s12, s20
.Le1871:
.balign 4
.hword (.Le1872 - .Lb1872) / 2, 0
.Lb1872:
vnmla.f32 s12, s7, s10
.Le1872:
.balign 4
.hword (.Le1873 - .Lb1873) / 2, 0
.Lb1873:
vnmla.f32 s26, s26, s16
.Le1873:
.balign 4
.hword (.Le1874 - .Lb1874) / 2, 0
.Lb1874:
vnmla.f32 s8, s5, s16
.Le1874:
.balign 4
.hword (.Le1875 - .Lb1875) / 2, 0
.Lb1875:
vnmla.f32 s15, s17, s11
.Le1875:
.balign 4
.hword (.Le1876 - .Lb1876) / 2, 0
.Lb1876:
vnmla.f32 s29, s27, s1
.Le1876:
.balign 4
.hword (.Le1877 - .Lb1877) / 2, 0
.Lb1877:
vnmla.f32 s9, s19, s8
.Le1877:
.balign 4
.hword (.Le1878 - .Lb1878) / 2, 0
.Lb1878:
vnmla.f32 s9, s26, s2
.Le1878:
.balign 4
.hword (.Le1879 - .Lb1879) / 2, 0
.Lb1879:
vnmla.f32 s29, s31, s2
.Le1879:
.balign 4
.hword (.Le1880 - .Lb1880) / 2, 0
.Lb1880:
vnmla.f32 s24, s6, s18
.Le1880:
.balign 4
.hword (.Le1881 - .Lb1881) / 2, 0
.Lb1881:
vnmla.f32 s26, s29, s6
.Le1881:
.balign 4
.hword (.Le1882 - .Lb1882) / 2, 0
.Lb1882:
vnmla.f32 s27, s26, s1
.Le1882:
.balign 4
.hword (.Le1883 - .Lb1883) / 2, 0
.Lb1883:
vnmla.f32 s16, s3, s18
.Le1883:
.balign 4
.hword (.Le1884 - .Lb1884) / 2, 0
.Lb1884:
vnmla.f32 s16, s20, s1
.Le1884:
.balign 4
.hword (.Le1885 - .Lb1885) / 2, 0
.Lb1885:
vnmla.f32 s8, s3, s13
.Le1885:
.balign 4
.hword (.Le1886 - .Lb1886) / 2, 0
.Lb1886:
vnmla.f32 s20, s6, s10
.Le1886:
.balign 4
.hword (.Le1887 - .Lb1887) / 2, 0
.Lb1887:
vnmla.f32 s19, s26, s9
.Le1887:
.balign 4
.hword 0xffff, 0
.balign 4
group_vnmls:
.balign 4
.hword (.Le1888 - .Lb1888) / 2, 0
.Lb1888:
vnmls.f32 s5, s31, s4
.Le1888:
.balign 4
.hword (.Le1889 - .Lb1889) / 2, 0
.Lb1889:
vnmls.f32 s27, s23, s9
.Le1889:
.balign 4
.hword (.Le1890 - .Lb1890) / 2, 0
.Lb1890:
vnmls.f32 s29, s25, s20
.Le1890:
.balign 4
.hword (.Le1891 - .Lb1891) / 2, 0
.Lb1891:
vnmls.f32 s18, s31, s4
.Le1891:
.balign 4
.hword (.Le1892 - .Lb1892) / 2, 0
.Lb1892:
vnmls.f32 s8, s1, s5
.Le1892:
.balign 4
.hword (.Le1893 - .Lb1893) / 2, 0
.Lb1893:
vnmls.f32 s13, s23, s30
.Le1893:
.balign 4
.hword (.Le1894 - .Lb1894) / 2, 0
.Lb1894:
vnmls.f32 s9, s11, s8
.Le1894:
.balign 4
.hword (.Le1895 - .Lb1895) / 2, 0
.Lb1895:
vnmls.f32 s27, s2, s4
.Le1895:
.balign 4
.hword (.Le1896 - .Lb1896) / 2, 0
.Lb1896:
vnmls.f32 s22, s19, s16
.Le1896:
.balign 4
.hword (.Le1897 - .Lb1897) / 2, 0
.Lb1897:
vnmls.f32 s23, s23, s19
.Le1897:
.balign 4
.hword (.Le1898 - .Lb1898) / 2, 0
.Lb1898:
vnmls.f32 s26, s25, s30
.Le1898:
.balign 4
.hword (.Le1899 - .Lb1899) / 2, 0
.Lb1899:
vnmls.f32 s28, s23, s20
.Le1899:
.balign 4
.hword (.Le1900 - .Lb1900) / 2, 0
.Lb1900:
vnmls.f32 s26, s9, s8
.Le1900:
.balign 4
.hword (.Le1901 - .Lb1901) / 2, 0
.Lb1901:
vnmls.f32 s30, s16, s16
.Le1901:
.balign 4
.hword (.Le1902 - .Lb1902) / 2, 0
.Lb1902:
vnmls.f32 s27, s30, s3
.Le1902:
.balign 4
.hword (.Le1903 - .Lb1903) / 2, 0
.Lb1903:
vnmls.f32 s18, s31, s22
.Le1903:
.balign 4
.hword (.Le1904 - .Lb1904) / 2, 0
.Lb1904:
vnmls.f32 s31, s8, s28
.Le1904:
.balign 4
.hword (.Le1905 - .Lb1905) / 2, 0
.Lb1905:
vnmls.f32 s9, s30, s9
.Le1905:
.balign 4
.hword (.Le1906 - .Lb1906) / 2, 0
.Lb1906:
vnmls.f32 s14, s21, s4
.Le1906:
.balign 4
.hword (.Le1907 - .Lb1907) / 2, 0
.Lb1907:
vnmls.f32 s23, s10, s26
.Le1907:
.balign 4
.hword (.Le1908 - .Lb1908) / 2, 0
.Lb1908:
vnmls.f32 s26, s19, s17
.Le1908:
.balign 4
.hword (.Le1909 - .Lb1909) / 2, 0
.Lb1909:
vnmls.f32 s14, s0, s30
.Le1909:
.balign 4
.hword (.Le1910 - .Lb1910) / 2, 0
.Lb1910:
vnmls.f32 s22, s5, s16
.Le1910:
.balign 4
.hword (.Le1911 - .Lb1911) / 2, 0
.Lb1911:
vnmls.f32 s31, s25, s29
.Le1911:
.balign 4
.hword 0xffff, 0
.balign 4
group_vfma:
.balign 4
.hword (.Le1912 - .Lb1912) / 2, 0
.Lb1912:
vfma.f32 s2, s27, s16
.Le1912:
.balign 4
.hword (.Le1913 - .Lb1913) / 2, 0
.Lb1913:
vfma.f32 s31, s9, s20
.Le1913:
.balign 4
.hword (.Le1914 - .Lb1914) / 2, 0
.Lb1914:
vfma.f32 s9, s13, s24
.Le1914:
.balign 4
.hword (.Le1915 - .Lb1915) / 2, 0
.Lb1915:
vfma.f32 s7, s7, s20
.Le1915:
.balign 4
.hword (.Le1916 - .Lb1916) / 2, 0
.Lb1916:
vfma.f32 s9, s30, s28
.Le1916:
.balign 4
.hword (.Le1917 - .Lb1917) / 2, 0
.Lb1917:
vfma.f32 s9, s31, s9
.Le1917:
.balign 4
.hword (.Le1918 - .Lb1918) / 2, 0
.Lb1918:
vfma.f32 s3, s12, s25
.Le1918:
.balign 4
.hword (.Le1919 - .Lb1919) / 2, 0
.Lb1919:
vfma.f32 s21, s16, s31
.Le1919:
.balign 4
.hword (.Le1920 - .Lb1920) / 2, 0
.Lb1920:
vfma.f32 s18, s2, s27
.Le1920:
.balign 4
.hword (.Le1921 - .Lb1921) / 2, 0
.Lb1921:
vfma.f32 s5, s13, s1
.Le1921:
.balign 4
.hword (.Le1922 - .Lb1922) / 2, 0
.Lb1922:
vfma.f32 s20, s25, s18
.Le1922:
.balign 4
.hword (.Le1923 - .Lb1923) / 2, 0
.Lb1923:
vfma.f32 s15, s19, s27
.Le1923:
.balign 4
.hword (.Le1924 - .Lb1924) / 2, 0
.Lb1924:
vfma.f32 s22, s28, s20
.Le1924:
.balign 4
.hword (.Le1925 - .Lb1925) / 2, 0
.Lb1925:
vfma.f32 s17, s7, s23
.Le1925:
.balign 4
.hword (.Le1926 - .Lb1926) / 2, 0
.Lb1926:
vfma.f32 s2, s18, s13
.Le1926:
.balign 4
.hword (.Le1927 - .Lb1927) / 2, 0
.Lb1927:
vfma.f32 s6, s16, s1
.Le1927:
.balign 4
.hword (.Le1928 - .Lb1928) / 2, 0
.Lb1928:
vfma.f32 s16, s21, s7
.Le1928:
.balign 4
.hword (.Le1929 - .Lb1929) / 2, 0
.Lb1929:
vfma.f32 s25, s29, s18
.Le1929:
.balign 4
.hword (.Le1930 - .Lb1930) / 2, 0
.Lb1930:
vfma.f32 s17, s23, s9
.Le1930:
.balign 4
.hword (.Le1931 - .Lb1931) / 2, 0
.Lb1931:
vfma.f32 s31, s3, s6
.Le1931:
.balign 4
.hword (.Le1932 - .Lb1932) / 2, 0
.Lb1932:
vfma.f32 s24, s28, s20
.Le1932:
.balign 4
.hword (.Le1933 - .Lb1933) / 2, 0
.Lb1933:
vfma.f32 s0, s29, s15
.Le1933:
.balign 4
.hword (.Le1934 - .Lb1934) / 2, 0
.Lb1934:
vfma.f32 s8, s20, s9
.Le1934:
.balign 4
.hword (.Le1935 - .Lb1935) / 2, 0
.Lb1935:
vfma.f32 s13, s31, s10
.Le1935:
.balign 4
.hword 0xffff, 0
.balign 4
group_vfms:
.balign 4
.hword (.Le1936 - .Lb1936) / 2, 0
.Lb1936:
vfms.f32 s18, s22, s14
.Le1936:
.balign 4
.hword (.Le1937 - .Lb1937) / 2, 0
.Lb1937:
vfms.f32 s13, s3, s29
.Le1937:
.balign 4
.hword (.Le1938 - .Lb1938) / 2, 0
.Lb1938:
vfms.f32 s17, s29, s29
.Le1938:
.balign 4
.hword (.Le1939 - .Lb1939) / 2, 0
.Lb1939:
vfms.f32 s30, s23, s27
.Le1939:
.balign 4
.hword (.Le1940 - .Lb1940) / 2, 0
.Lb1940:
vfms.f32 s27, s4, s14
.Le1940:
.balign 4
.hword (.Le1941 - .Lb1941) / 2, 0
.Lb1941:
vfms.f32 s22, s3, s20
.Le1941:
.balign 4
.hword (.Le1942 - .Lb1942) / 2, 0
.Lb1942:
vfms.f32 s6, s24, s31
.Le1942:
.balign 4
.hword (.Le1943 - .Lb1943) / 2, 0
.Lb1943:
vfms.f32 s21, s9, s12
.Le1943:
.balign 4
.hword (.Le1944 - .Lb1944) / 2, 0
.Lb1944:
vfms.f32 s4, s17, s31
.Le1944:
.balign 4
.hword (.Le1945 - .Lb1945) / 2, 0
.Lb1945:
vfms.f32 s31, s29, s20
.Le1945:
.balign 4
.hword (.Le1946 - .Lb1946) / 2, 0
.Lb1946:
vfms.f32 s29, s5, s31
.Le1946:
.balign 4
.hword (.Le1947 - .Lb1947) / 2, 0
.Lb1947:
vfms.f32 s17, s7, s8
.Le1947:
.balign 4
.hword (.Le1948 - .Lb1948) / 2, 0
.Lb1948:
vfms.f32 s26, s5, s9
.Le1948:
.balign 4
.hword (.Le1949 - .Lb1949) / 2, 0
.Lb1949:
vfms.f32 s24, s6, s27
.Le1949:
.balign 4
.hword (.Le1950 - .Lb1950) / 2, 0
.Lb1950:
vfms.f32 s13, s9, s0
.Le1950:
.balign 4
.hword (.Le1951 - .Lb1951) / 2, 0
.Lb1951:
vfms.f32 s7, s6, s5
.Le1951:
.balign 4
.hword (.Le1952 - .Lb1952) / 2, 0
.Lb1952:
vfms.f32 s21, s7, s23
.Le1952:
.balign 4
.hword (.Le1953 - .Lb1953) / 2, 0
.Lb1953:
vfms.f32 s26, s25, s4
.Le1953:
.balign 4
.hword (.Le1954 - .Lb1954) / 2, 0
.Lb1954:
vfms.f32 s26, s28, s19
.Le1954:
.balign 4
.hword (.Le1955 - .Lb1955) / 2, 0
.Lb1955:
vfms.f32 s27, s28, s25
.Le1955:
.balign 4
.hword (.Le1956 - .Lb1956) / 2, 0
.Lb1956:
vfms.f32 s8, s29, s30
.Le1956:
.balign 4
.hword (.Le1957 - .Lb1957) / 2, 0
.Lb1957:
vfms.f32 s24, s6, s21
.Le1957:
.balign 4
.hword (.Le1958 - .Lb1958) / 2, 0
.Lb1958:
vfms.f32 s17, s9, s16
.Le1958:
.balign 4
.hword (.Le1959 - .Lb1959) / 2, 0
.Lb1959:
vfms.f32 s2, s6, s10
.Le1959:
.balign 4
.hword 0xffff, 0
.balign 4
group_vfnma:
.balign 4
.hword (.Le1960 - .Lb1960) / 2, 0
.Lb1960:
vfnma.f32 s2, s0, s20
.Le1960:
.balign 4
.hword (.Le1961 - .Lb1961) / 2, 0
.Lb1961:
vfnma.f32 s21, s2, s10
.Le1961:
.balign 4
.hword (.Le1962 - .Lb1962) / 2, 0
.Lb1962:
vfnma.f32 s26, s28, s1
.Le1962:
.balign 4
.hword (.Le1963 - .Lb1963) / 2, 0
.Lb1963:
vfnma.f32 s27, s25, s7
.Le1963:
.balign 4
.hword (.Le1964 - .Lb1964) / 2, 0
.Lb1964:
vfnma.f32 s25, s3, s1
.Le1964:
.balign 4
.hword (.Le1965 - .Lb1965) / 2, 0
.Lb1965:
vfnma.f32 s8, s15, s31
.Le1965:
.balign 4
.hword (.Le1966 - .Lb1966) / 2, 0
.Lb1966:
vfnma.f32 s24, s20, s8
.Le1966:
.balign 4
.hword (.Le1967 - .Lb1967) / 2, 0
.Lb1967:
vfnma.f32 s18, s8, s8
.Le1967:
.balign 4
.hword (.Le1968 - .Lb1968) / 2, 0
.Lb1968:
vfnma.f32 s9, s9, s15
.Le1968:
.balign 4
.hword (.Le1969 - .Lb1969) / 2, 0
.Lb1969:
vfnma.f32 s12, s1, s13
.Le1969:
.balign 4
.hword (.Le1970 - .Lb1970) / 2, 0
.Lb1970:
vfnma.f32 s31, s29, s23
.Le1970:
.balign 4
.hword (.Le1971 - .Lb1971) / 2, 0
.Lb1971:
vfnma.f32 s30, s27, s0
.Le1971:
.balign 4
.hword (.Le1972 - .Lb1972) / 2, 0
.Lb1972:
vfnma.f32 s26, s15, s24
.Le1972:
.balign 4
.hword (.Le1973 - .Lb1973) / 2, 0
.Lb1973:
vfnma.f32 s17, s1, s20
.Le1973:
.balign 4
.hword (.Le1974 - .Lb1974) / 2, 0
.Lb1974:
vfnma.f32 s6, s15, s27
.Le1974:
.balign 4
.hword (.Le1975 - .Lb1975) / 2, 0
.Lb1975:
vfnma.f32 s16, s8, s29
.Le1975:
.balign 4
.hword (.Le1976 - .Lb1976) / 2, 0
.Lb1976:
vfnma.f32 s23, s16, s7
.Le1976:
.balign 4
.hword (.Le1977 - .Lb1977) / 2, 0
.Lb1977:
vfnma.f32 s5, s22, s25
.Le1977:
.balign 4
.hword (.Le1978 - .Lb1978) / 2, 0
.Lb1978:
vfnma.f32 s28, s23, s26
.Le1978:
.balign 4
.hword (.Le1979 - .Lb1979) / 2, 0
.Lb1979:
vfnma.f32 s28, s31, s24
.Le1979:
.balign 4
.hword (.Le1980 - .Lb1980) / 2, 0
.Lb1980:
vfnma.f32 s1, s3, s31
.Le1980:
.balign 4
.hword (.Le1981 - .Lb1981) / 2, 0
.Lb1981:
vfnma.f32 s20, s14, s6
.Le1981:
.balign 4
.hword (.Le1982 - .Lb1982) / 2, 0
.Lb1982:
vfnma.f32 s1, s22, s4
.Le1982:
.balign 4
.hword (.Le1983 - .Lb1983) / 2, 0
.Lb1983:
vfnma.f32 s11, s30, s7
.Le1983:
.balign 4
.hword 0xffff, 0
.balign 4
group_vfnms:
.balign 4
.hword (.Le1984 - .Lb1984) / 2, 0
.Lb1984:
vfnms.f32 s14, s9, s29
.Le1984:
.balign 4
.hword (.Le1985 - .Lb1985) / 2, 0
.Lb1985:
vfnms.f32 s4, s10, s17
.Le1985:
.balign 4
.hword (.Le1986 - .Lb1986) / 2, 0
.Lb1986:
vfnms.f32 s30, s23, s11
.Le1986:
.balign 4
.hword (.Le1987 - .Lb1987) / 2, 0
.Lb1987:
vfnms.f32 s14, s2, s18
.Le1987:
.balign 4
.hword (.Le1988 - .Lb1988) / 2, 0
.Lb1988:
vfnms.f32 s28, s29, s18
.Le1988:
.balign 4
.hword (.Le1989 - .Lb1989) / 2, 0
.Lb1989:
vfnms.f32 s15, s0, s19
.Le1989:
.balign 4
.hword (.Le1990 - .Lb1990) / 2, 0
.Lb1990:
vfnms.f32 s30, s9, s12
.Le1990:
.balign 4
.hword (.Le1991 - .Lb1991) / 2, 0
.Lb1991:
vfnms.f32 s12, s11, s19
.Le1991:
.balign 4
.hword (.Le1992 - .Lb1992) / 2, 0
.Lb1992:
vfnms.f32 s4, s16, s10
.Le1992:
.balign 4
.hword (.Le1993 - .Lb1993) / 2, 0
.Lb1993:
vfnms.f32 s25, s19, s11
.Le1993:
.balign 4
.hword (.Le1994 - .Lb1994) / 2, 0
.Lb1994:
vfnms.f32 s29, s25, s5
.Le1994:
.balign 4
.hword (.Le1995 - .Lb1995) / 2, 0
.Lb1995:
vfnms.f32 s22, s22, s14
.Le1995:
.balign 4
.hword (.Le1996 - .Lb1996) / 2, 0
.Lb1996:
vfnms.f32 s0, s10, s29
.Le1996:
.balign 4
.hword (.Le1997 - .Lb1997) / 2, 0
.Lb1997:
vfnms.f32 s8, s18, s24
.Le1997:
.balign 4
.hword (.Le1998 - .Lb1998) / 2, 0
.Lb1998:
vfnms.f32 s9, s21, s21
.Le1998:
.balign 4
.hword (.Le1999 - .Lb1999) / 2, 0
.Lb1999:
vfnms.f32 s16, s0, s9
.Le1999:
.balign 4
.hword (.Le2000 - .Lb2000) / 2, 0
.Lb2000:
vfnms.f32 s12, s16, s13
.Le2000:
.balign 4
.hword (.Le2001 - .Lb2001) / 2, 0
.Lb2001:
vfnms.f32 s0, s3, s2
.Le2001:
.balign 4
.hword (.Le2002 - .Lb2002) / 2, 0
.Lb2002:
vfnms.f32 s29, s18, s14
.Le2002:
.balign 4
.hword (.Le2003 - .Lb2003) / 2, 0
.Lb2003:
vfnms.f32 s7, s4, s9
.Le2003:
.balign 4
.hword (.Le2004 - .Lb2004) / 2, 0
.Lb2004:
vfnms.f32 s12, s11, s1
.Le2004:
.balign 4
.hword (.Le2005 - .Lb2005) / 2, 0
.Lb2005:
vfnms.f32 s27, s10, s10
.Le2005:
.balign 4
.hword (.Le2006 - .Lb2006) / 2, 0
.Lb2006:
vfnms.f32 s28, s20, s3
.Le2006:
.balign 4
.hword (.Le2007 - .Lb2007) / 2, 0
.Lb2007:
vfnms.f32 s28, s22, s18
.Le2007:
.balign 4
.hword 0xffff, 0
.balign 4
group_vabs:
.balign 4
.hword (.Le2008 - .Lb2008) / 2, 0
.Lb2008:
vabs.f32 s8, s15
.Le2008:
.balign 4
.hword (.Le2009 - .Lb2009) / 2, 0
.Lb2009:
vabs.f32 s7, s31
.Le2009:
.balign 4
.hword (.Le2010 - .Lb2010) / 2, 0
.Lb2010:
vabs.f32 s14, s7
.Le2010:
.balign 4
.hword (.Le2011 - .Lb2011) / 2, 0
.Lb2011:
vabs.f32 s19, s17
.Le2011:
.balign 4
.hword (.Le2012 - .Lb2012) / 2, 0
.Lb2012:
vabs.f32 s26, s7
.Le2012:
.balign 4
.hword (.Le2013 - .Lb2013) / 2, 0
.Lb2013:
vabs.f32 s1, s23
.Le2013:
.balign 4
.hword (.Le2014 - .Lb2014) / 2, 0
.Lb2014:
vabs.f32 s11, s20
.Le2014:
.balign 4
.hword (.Le2015 - .Lb2015) / 2, 0
.Lb2015:
vabs.f32 s10, s2
.Le2015:
.balign 4
.hword (.Le2016 - .Lb2016) / 2, 0
.Lb2016:
vabs.f32 s1, s15
.Le2016:
.balign 4
.hword (.Le2017 - .Lb2017) / 2, 0
.Lb2017:
vabs.f32 s1, s30
.Le2017:
.balign 4
.hword (.Le2018 - .Lb2018) / 2, 0
.Lb2018:
vabs.f32 s31, s5
.Le2018:
.balign 4
.hword (.Le2019 - .Lb2019) / 2, 0
.Lb2019:
vabs.f32 s12, s22
.Le2019:
.balign 4
.hword (.Le2020 - .Lb2020) / 2, 0
.Lb2020:
vabs.f32 s5, s9
.Le2020:
.balign 4
.hword (.Le2021 - .Lb2021) / 2, 0
.Lb2021:
vabs.f32 s23, s29
.Le2021:
.balign 4
.hword (.Le2022 - .Lb2022) / 2, 0
.Lb2022:
vabs.f32 s24, s22
.Le2022:
.balign 4
.hword (.Le2023 - .Lb2023) / 2, 0
.Lb2023:
vabs.f32 s5, s14
.Le2023:
.balign 4
.hword 0xffff, 0
.balign 4
group_vneg:
.balign 4
.hword (.Le2024 - .Lb2024) / 2, 0
.Lb2024:
vneg.f32 s6, s5
.Le2024:
.balign 4
.hword (.Le2025 - .Lb2025) / 2, 0
.Lb2025:
vneg.f32 s19, s5
.Le2025:
.balign 4
.hword (.Le2026 - .Lb2026) / 2, 0
.Lb2026:
vneg.f32 s7, s15
.Le2026:
.balign 4
.hword (.Le2027 - .Lb2027) / 2, 0
.Lb2027:
vneg.f32 s18, s7
.Le2027:
.balign 4
.hword (.Le2028 - .Lb2028) / 2, 0
.Lb2028:
vneg.f32 s10, s13
.Le2028:
.balign 4
.hword (.Le2029 - .Lb2029) / 2, 0
.Lb2029:
vneg.f32 s29, s12
.Le2029:
.balign 4
.hword (.Le2030 - .Lb2030) / 2, 0
.Lb2030:
vneg.f32 s5, s4
.Le2030:
.balign 4
.hword (.Le2031 - .Lb2031) / 2, 0
.Lb2031:
vneg.f32 s24, s15
.Le2031:
.balign 4
.hword (.Le2032 - .Lb2032) / 2, 0
.Lb2032:
vneg.f32 s19, s30
.Le2032:
.balign 4
.hword (.Le2033 - .Lb2033) / 2, 0
.Lb2033:
vneg.f32 s24, s6
.Le2033:
.balign 4
.hword (.Le2034 - .Lb2034) / 2, 0
.Lb2034:
vneg.f32 s23, s30
.Le2034:
.balign 4
.hword (.Le2035 - .Lb2035) / 2, 0
.Lb2035:
vneg.f32 s25, s21
.Le2035:
.balign 4
.hword (.Le2036 - .Lb2036) / 2, 0
.Lb2036:
vneg.f32 s9, s20
.Le2036:
.balign 4
.hword (.Le2037 - .Lb2037) / 2, 0
.Lb2037:
vneg.f32 s12, s25
.Le2037:
.balign 4
.hword (.Le2038 - .Lb2038) / 2, 0
.Lb2038:
vneg.f32 s17, s6
.Le2038:
.balign 4
.hword (.Le2039 - .Lb2039) / 2, 0
.Lb2039:
vneg.f32 s8, s23
.Le2039:
.balign 4
.hword 0xffff, 0
.balign 4
group_vsqrt:
.balign 4
.hword (.Le2040 - .Lb2040) / 2, 0
.Lb2040:
vsqrt.f32 s30, s2
.Le2040:
.balign 4
.hword (.Le2041 - .Lb2041) / 2, 0
.Lb2041:
vsqrt.f32 s3, s8
.Le2041:
.balign 4
.hword (.Le2042 - .Lb2042) / 2, 0
.Lb2042:
vsqrt.f32 s29, s13
.Le2042:
.balign 4
.hword (.Le2043 - .Lb2043) / 2, 0
.Lb2043:
vsqrt.f32 s17, s9
.Le2043:
.balign 4
.hword (.Le2044 - .Lb2044) / 2, 0
.Lb2044:
vsqrt.f32 s18, s20
.Le2044:
.balign 4
.hword (.Le2045 - .Lb2045) / 2, 0
.Lb2045:
vsqrt.f32 s14, s20
.Le2045:
.balign 4
.hword (.Le2046 - .Lb2046) / 2, 0
.Lb2046:
vsqrt.f32 s12, s26
.Le2046:
.balign 4
.hword (.Le2047 - .Lb2047) / 2, 0
.Lb2047:
vsqrt.f32 s13, s8
.Le2047:
.balign 4
.hword (.Le2048 - .Lb2048) / 2, 0
.Lb2048:
vsqrt.f32 s5, s1
.Le2048:
.balign 4
.hword (.Le2049 - .Lb2049) / 2, 0
.Lb2049:
vsqrt.f32 s24, s25
.Le2049:
.balign 4
.hword (.Le2050 - .Lb2050) / 2, 0
.Lb2050:
vsqrt.f32 s22, s9
.Le2050:
.balign 4
.hword (.Le2051 - .Lb2051) / 2, 0
.Lb2051:
vsqrt.f32 s5, s12
.Le2051:
.balign 4
.hword (.Le2052 - .Lb2052) / 2, 0
.Lb2052:
vsqrt.f32 s31, s24
.Le2052:
.balign 4
.hword (.Le2053 - .Lb2053) / 2, 0
.Lb2053:
vsqrt.f32 s20, s0
.Le2053:
.balign 4
.hword (.Le2054 - .Lb2054) / 2, 0
.Lb2054:
vsqrt.f32 s16, s24
.Le2054:
.balign 4
.hword (.Le2055 - .Lb2055) / 2, 0
.Lb2055:
vsqrt.f32 s25, s10
.Le2055:
.balign 4
.hword 0xffff, 0
.balign 4
group_vcmp:
.balign 4
.hword (.Le2056 - .Lb2056) / 2, 0
.Lb2056:
vcmp.f32 s16, s26
vmrs apsr_nzcv, fpscr
.Le2056:
.balign 4
.hword (.Le2057 - .Lb2057) / 2, 0
.Lb2057:
vcmp.f32 s7, s25
vmrs apsr_nzcv, fpscr
.Le2057:
.balign 4
.hword (.Le2058 - .Lb2058) / 2, 0
.Lb2058:
vcmp.f32 s3, s5
vmrs apsr_nzcv, fpscr
.Le2058:
.balign 4
.hword (.Le2059 - .Lb2059) / 2, 0
.Lb2059:
vcmp.f32 s5, s21
vmrs apsr_nzcv, fpscr
.Le2059:
.balign 4
.hword (.Le2060 - .Lb2060) / 2, 0
.Lb2060:
vcmp.f32 s24, s22
vmrs apsr_nzcv, fpscr
.Le2060:
.balign 4
.hword (.Le2061 - .Lb2061) / 2, 0
.Lb2061:
vcmp.f32 s16, s26
vmrs apsr_nzcv, fpscr
.Le2061:
.balign 4
.hword (.Le2062 - .Lb2062) / 2, 0
.Lb2062:
vcmp.f32 s8, s25
vmrs apsr_nzcv, fpscr
.Le2062:
.balign 4
.hword (.Le2063 - .Lb2063) / 2, 0
.Lb2063:
vcmp.f32 s2, s12
vmrs apsr_nzcv, fpscr
.Le2063:
.balign 4
.hword (.Le2064 - .Lb2064) / 2, 0
.Lb2064:
vcmp.f32 s9, s11
vmrs apsr_nzcv, fpscr
.Le2064:
.balign 4
.hword (.Le2065 - .Lb2065) / 2, 0
.Lb2065:
vcmp.f32 s6, s26
vmrs apsr_nzcv, fpscr
.Le2065:
.balign 4
.hword (.Le2066 - .Lb2066) / 2, 0
.Lb2066:
vcmp.f32 s3, s23
vmrs apsr_nzcv, fpscr
.Le2066:
.balign 4
.hword (.Le2067 - .Lb2067) / 2, 0
.Lb2067:
vcmp.f32 s22, s14
vmrs apsr_nzcv, fpscr
.Le2067:
.balign 4
.hword (.Le2068 - .Lb2068) / 2, 0
.Lb2068:
vcmp.f32 s22, s4
vmrs apsr_nzcv, fpscr
.Le2068:
.balign 4
.hword (.Le2069 - .Lb2069) / 2, 0
.Lb2069:
vcmp.f32 s14, s8
vmrs apsr_nzcv, fpscr
.Le2069:
.balign 4
.hword (.Le2070 - .Lb2070) / 2, 0
.Lb2070:
vcmp.f32 s22, s5
vmrs apsr_nzcv, fpscr
.Le2070:
.balign 4
.hword (.Le2071 - .Lb2071) / 2, 0
.Lb2071:
vcmp.f32 s29, s24
vmrs apsr_nzcv, fpscr
.Le2071:
.balign 4
.hword (.Le2072 - .Lb2072) / 2, 0
.Lb2072:
vcmpe.f32 s16, s29
vmrs apsr_nzcv, fpscr
.Le2072:
.balign 4
.hword (.Le2073 - .Lb2073) / 2, 0
.Lb2073:
vcmpe.f32 s29, s16
vmrs apsr_nzcv, fpscr
.Le2073:
.balign 4
.hword (.Le2074 - .Lb2074) / 2, 0
.Lb2074:
vcmpe.f32 s0, s27
vmrs apsr_nzcv, fpscr
.Le2074:
.balign 4
.hword (.Le2075 - .Lb2075) / 2, 0
.Lb2075:
vcmpe.f32 s15, s29
vmrs apsr_nzcv, fpscr
.Le2075:
.balign 4
.hword (.Le2076 - .Lb2076) / 2, 0
.Lb2076:
vcmpe.f32 s21, s0
vmrs apsr_nzcv, fpscr
.Le2076:
.balign 4
.hword (.Le2077 - .Lb2077) / 2, 0
.Lb2077:
vcmpe.f32 s9, s6
vmrs apsr_nzcv, fpscr
.Le2077:
.balign 4
.hword (.Le2078 - .Lb2078) / 2, 0
.Lb2078:
vcmpe.f32 s14, s23
vmrs apsr_nzcv, fpscr
.Le2078:
.balign 4
.hword (.Le2079 - .Lb2079) / 2, 0
.Lb2079:
vcmpe.f32 s14, s28
vmrs apsr_nzcv, fpscr
.Le2079:
.balign 4
.hword (.Le2080 - .Lb2080) / 2, 0
.Lb2080:
vcmpe.f32 s22, s2
vmrs apsr_nzcv, fpscr
.Le2080:
.balign 4
.hword (.Le2081 - .Lb2081) / 2, 0
.Lb2081:
vcmpe.f32 s11, s22
vmrs apsr_nzcv, fpscr
.Le2081:
.balign 4
.hword (.Le2082 - .Lb2082) / 2, 0
.Lb2082:
vcmpe.f32 s22, s19
vmrs apsr_nzcv, fpscr
.Le2082:
.balign 4
.hword (.Le2083 - .Lb2083) / 2, 0
.Lb2083:
vcmpe.f32 s16, s5
vmrs apsr_nzcv, fpscr
.Le2083:
.balign 4
.hword (.Le2084 - .Lb2084) / 2, 0
.Lb2084:
vcmpe.f32 s3, s17
vmrs apsr_nzcv, fpscr
.Le2084:
.balign 4
.hword (.Le2085 - .Lb2085) / 2, 0
.Lb2085:
vcmpe.f32 s19, s27
vmrs apsr_nzcv, fpscr
.Le2085:
.balign 4
.hword (.Le2086 - .Lb2086) / 2, 0
.Lb2086:
vcmpe.f32 s12, s17
vmrs apsr_nzcv, fpscr
.Le2086:
.balign 4
.hword (.Le2087 - .Lb2087) / 2, 0
.Lb2087:
vcmpe.f32 s5, s25
vmrs apsr_nzcv, fpscr
.Le2087:
.balign 4
.hword 0xffff, 0
.balign 4
group_vcmp_zero:
.balign 4
.hword (.Le2088 - .Lb2088) / 2, 0
.Lb2088:
vcmp.f32 s18, #0
.Le2088:
.balign 4
.hword (.Le2089 - .Lb2089) / 2, 0
.Lb2089:
vcmp.f32 s5, #0
.Le2089:
.balign 4
.hword (.Le2090 - .Lb2090) / 2, 0
.Lb2090:
vcmp.f32 s12, #0
.Le2090:
.balign 4
.hword (.Le2091 - .Lb2091) / 2, 0
.Lb2091:
vcmp.f32 s22, #0
.Le2091:
.balign 4
.hword (.Le2092 - .Lb2092) / 2, 0
.Lb2092:
vcmp.f32 s5, #0
.Le2092:
.balign 4
.hword (.Le2093 - .Lb2093) / 2, 0
.Lb2093:
vcmp.f32 s28, #0
.Le2093:
.balign 4
.hword (.Le2094 - .Lb2094) / 2, 0
.Lb2094:
vcmp.f32 s2, #0
.Le2094:
.balign 4
.hword (.Le2095 - .Lb2095) / 2, 0
.Lb2095:
vcmp.f32 s5, #0
.Le2095:
.balign 4
.hword (.Le2096 - .Lb2096) / 2, 0
.Lb2096:
vcmp.f32 s3, #0
.Le2096:
.balign 4
.hword (.Le2097 - .Lb2097) / 2, 0
.Lb2097:
vcmp.f32 s8, #0
.Le2097:
.balign 4
.hword (.Le2098 - .Lb2098) / 2, 0
.Lb2098:
vcmp.f32 s30, #0
.Le2098:
.balign 4
.hword (.Le2099 - .Lb2099) / 2, 0
.Lb2099:
vcmp.f32 s16, #0
.Le2099:
.balign 4
.hword (.Le2100 - .Lb2100) / 2, 0
.Lb2100:
vcmp.f32 s23, #0
.Le2100:
.balign 4
.hword (.Le2101 - .Lb2101) / 2, 0
.Lb2101:
vcmp.f32 s9, #0
.Le2101:
.balign 4
.hword (.Le2102 - .Lb2102) / 2, 0
.Lb2102:
vcmp.f32 s2, #0
.Le2102:
.balign 4
.hword (.Le2103 - .Lb2103) / 2, 0
.Lb2103:
vcmp.f32 s24, #0
.Le2103:
.balign 4
.hword (.Le2104 - .Lb2104) / 2, 0
.Lb2104:
vcmpe.f32 s19, #0
.Le2104:
.balign 4
.hword (.Le2105 - .Lb2105) / 2, 0
.Lb2105:
vcmpe.f32 s27, #0
.Le2105:
.balign 4
.hword (.Le2106 - .Lb2106) / 2, 0
.Lb2106:
vcmpe.f32 s24, #0
.Le2106:
.balign 4
.hword (.Le2107 - .Lb2107) / 2, 0
.Lb2107:
vcmpe.f32 s6, #0
.Le2107:
.balign 4
.hword (.Le2108 - .Lb2108) / 2, 0
.Lb2108:
vcmpe.f32 s24, #0
.Le2108:
.balign 4
.hword (.Le2109 - .Lb2109) / 2, 0
.Lb2109:
vcmpe.f32 s4, #0
.Le2109:
.balign 4
.hword (.Le2110 - .Lb2110) / 2, 0
.Lb2110:
vcmpe.f32 s4, #0
.Le2110:
.balign 4
.hword (.Le2111 - .Lb2111) / 2, 0
.Lb2111:
vcmpe.f32 s19, #0
.Le2111:
.balign 4
.hword (.Le2112 - .Lb2112) / 2, 0
.Lb2112:
vcmpe.f32 s31, #0
.Le2112:
.balign 4
.hword (.Le2113 - .Lb2113) / 2, 0
.Lb2113:
vcmpe.f32 s9, #0
.Le2113:
.balign 4
.hword (.Le2114 - .Lb2114) / 2, 0
.Lb2114:
vcmpe.f32 s17, #0
.Le2114:
.balign 4
.hword (.Le2115 - .Lb2115) / 2, 0
.Lb2115:
vcmpe.f32 s28, #0
.Le2115:
.balign 4
.hword (.Le2116 - .Lb2116) / 2, 0
.Lb2116:
vcmpe.f32 s20, #0
.Le2116:
.balign 4
.hword (.Le2117 - .Lb2117) / 2, 0
.Lb2117:
vcmpe.f32 s17, #0
.Le2117:
.balign 4
.hword (.Le2118 - .Lb2118) / 2, 0
.Lb2118:
vcmpe.f32 s25, #0
.Le2118:
.balign 4
.hword (.Le2119 - .Lb2119) / 2, 0
.Lb2119:
vcmpe.f32 s13, #0
.Le2119:
.balign 4
.hword 0xffff, 0
.balign 4
group_vmov:
.balign 4
.hword (.Le2120 - .Lb2120) / 2, 0
.Lb2120:
vmov.f32 s22, s6
.Le2120:
.balign 4
.hword (.Le2121 - .Lb2121) / 2, 0
.Lb2121:
vmov.f32 s5, s14
.Le2121:
.balign 4
.hword (.Le2122 - .Lb2122) / 2, 0
.Lb2122:
vmov.f32 s21, s12
.Le2122:
.balign 4
.hword (.Le2123 - .Lb2123) / 2, 0
.Lb2123:
vmov.f32 s10, s10
.Le2123:
.balign 4
.hword (.Le2124 - .Lb2124) / 2, 0
.Lb2124:
vmov.f32 s3, #1.0
.Le2124:
.balign 4
.hword (.Le2125 - .Lb2125) / 2, 0
.Lb2125:
vmov.f32 s21, #-2.0
.Le2125:
.balign 4
.hword (.Le2126 - .Lb2126) / 2, 0
.Lb2126:
vmov.f32 s23, #0.125
.Le2126:
.balign 4
.hword (.Le2127 - .Lb2127) / 2, 0
.Lb2127:
vmov.f32 s31, #31.0
.Le2127:
.balign 4
.hword (.Le2128 - .Lb2128) / 2, 0
.Lb2128:
vmov.f32 s24, #1.9375
.Le2128:
.balign 4
.hword (.Le2129 - .Lb2129) / 2, 0
.Lb2129:
vmov.f32 s1, #-0.2421875
.Le2129:
.balign 4
.hword (.Le2130 - .Lb2130) / 2, 0
.Lb2130:
vmov r0, s3
.Le2130:
.balign 4
.hword (.Le2131 - .Lb2131) / 2, 0
.Lb2131:
vmov s31, r9
.Le2131:
.balign 4
.hword (.Le2132 - .Lb2132) / 2, 0
.Lb2132:
vmov r0, r1, s4, s5
.Le2132:
.balign 4
.hword (.Le2133 - .Lb2133) / 2, 0
.Lb2133:
vmov s30, s31, r5, r6
.Le2133:
.balign 4
.hword (.Le2134 - .Lb2134) / 2, 0
.Lb2134:
vmov r2, r3, d7
.Le2134:
.balign 4
.hword (.Le2135 - .Lb2135) / 2, 0
.Lb2135:
vmov d15, r4, r12
.Le2135:
.balign 4
.hword (.Le2136 - .Lb2136) / 2, 0
.Lb2136:
vmov.32 r0, d3[1]
.Le2136:
.balign 4
.hword (.Le2137 - .Lb2137) / 2, 0
.Lb2137:
vmov.32 d4[0], r1
.Le2137:
.balign 4
.hword (.Le2138 - .Lb2138) / 2, 0
.Lb2138:
vmov.32 d4[1], r2
.Le2138:
.balign 4
.hword (.Le2139 - .Lb2139) / 2, 0
.Lb2139:
vmrs r0, fpscr
.Le2139:
.balign 4
.hword (.Le2140 - .Lb2140) / 2, 0
.Lb2140:
vmsr fpscr, r1
vmrs r2, fpscr
.Le2140:
.balign 4
.hword 0xffff, 0
.balign 4
group_vcvt_int:
.balign 4
.hword (.Le2141 - .Lb2141) / 2, 0
.Lb2141:
vcvt.f32.s32 s13, s12
.Le2141:
.balign 4
.hword (.Le2142 - .Lb2142) / 2, 0
.Lb2142:
vcvt.f32.s32 s15, s12
.Le2142:
.balign 4
.hword (.Le2143 - .Lb2143) / 2, 0
.Lb2143:
vcvt.f32.s32 s26, s2
.Le2143:
.balign 4
.hword (.Le2144 - .Lb2144) / 2, 0
.Lb2144:
vcvt.f32.s32 s10, s13
.Le2144:
.balign 4
.hword (.Le2145 - .Lb2145) / 2, 0
.Lb2145:
vcvt.f32.s32 s6, s18
.Le2145:
.balign 4
.hword (.Le2146 - .Lb2146) / 2, 0
.Lb2146:
vcvt.f32.s32 s9, s23
.Le2146:
.balign 4
.hword (.Le2147 - .Lb2147) / 2, 0
.Lb2147:
vcvt.f32.s32 s11, s10
.Le2147:
.balign 4
.hword (.Le2148 - .Lb2148) / 2, 0
.Lb2148:
vcvt.f32.s32 s9, s5
.Le2148:
.balign 4
.hword (.Le2149 - .Lb2149) / 2, 0
.Lb2149:
vcvt.f32.s32 s28, s18
.Le2149:
.balign 4
.hword (.Le2150 - .Lb2150) / 2, 0
.Lb2150:
vcvt.f32.s32 s17, s28
.Le2150:
.balign 4
.hword (.Le2151 - .Lb2151) / 2, 0
.Lb2151:
vcvt.f32.s32 s15, s14
.Le2151:
.balign 4
.hword (.Le2152 - .Lb2152) / 2, 0
.Lb2152:
vcvt.f32.s32 s13, s15
.Le2152:
.balign 4
.hword (.Le2153 - .Lb2153) / 2, 0
.Lb2153:
vcvt.f32.s32 s27, s15
.Le2153:
.balign 4
.hword (.Le2154 - .Lb2154) / 2, 0
.Lb2154:
vcvt.f32.s32 s23, s26
.Le2154:
.balign 4
.hword (.Le2155 - .Lb2155) / 2, 0
.Lb2155:
vcvt.f32.s32 s12, s20
.Le2155:
.balign 4
.hword (.Le2156 - .Lb2156) / 2, 0
.Lb2156:
vcvt.f32.s32 s2, s14
.Le2156:
.balign 4
.hword (.Le2157 - .Lb2157) / 2, 0
.Lb2157:
vcvt.f32.u32 s9, s7
.Le2157:
.balign 4
.hword (.Le2158 - .Lb2158) / 2, 0
.Lb2158:
vcvt.f32.u32 s4, s27
.Le2158:
.balign 4
.hword (.Le2159 - .Lb2159) / 2, 0
.Lb2159:
vcvt.f32.u32 s24, s6
.Le2159:
.balign 4
.hword (.Le2160 - .Lb2160) / 2, 0
.Lb2160:
vcvt.f32.u32 s12, s25
.Le2160:
.balign 4
.hword (.Le2161 - .Lb2161) / 2, 0
.Lb2161:
vcvt.f32.u32 s13, s27
.Le2161:
.balign 4
.hword (.Le2162 - .Lb2162) / 2, 0
.Lb2162:
vcvt.f32.u32 s30, s6
.Le2162:
.balign 4
.hword (.Le2163 - .Lb2163) / 2, 0
.Lb2163:
vcvt.f32.u32 s24, s23
.Le2163:
.balign 4
.hword (.Le2164 - .Lb2164) / 2, 0
.Lb2164:
vcvt.f32.u32 s20, s26
.Le2164:
.balign 4
.hword (.Le2165 - .Lb2165) / 2, 0
.Lb2165:
vcvt.f32.u32 s15, s4
.Le2165:
.balign 4
.hword (.Le2166 - .Lb2166) / 2, 0
.Lb2166:
vcvt.f32.u32 s14, s16
.Le2166:
.balign 4
.hword (.Le2167 - .Lb2167) / 2, 0
.Lb2167:
vcvt.f32.u32 s26, s31
.Le2167:
.balign 4
.hword (.Le2168 - .Lb2168) / 2, 0
.Lb2168:
vcvt.f32.u32 s16, s25
.Le2168:
.balign 4
.hword (.Le2169 - .Lb2169) / 2, 0
.Lb2169:
vcvt.f32.u32 s22, s29
.Le2169:
.balign 4
.hword (.Le2170 - .Lb2170) / 2, 0
.Lb2170:
vcvt.f32.u32 s26, s3
.Le2170:
.balign 4
.hword (.Le2171 - .Lb2171) / 2, 0
.Lb2171:
vcvt.f32.u32 s18, s9
.Le2171:
.balign 4
.hword (.Le2172 - .Lb2172) / 2, 0
.Lb2172:
vcvt.f32.u32 s9, s18
.Le2172:
.balign 4
.hword (.Le2173 - .Lb2173) / 2, 0
.Lb2173:
vcvt.s32.f32 s28, s19
.Le2173:
.balign 4
.hword (.Le2174 - .Lb2174) / 2, 0
.Lb2174:
vcvt.s32.f32 s23, s16
.Le2174:
.balign 4
.hword (.Le2175 - .Lb2175) / 2, 0
.Lb2175:
vcvt.s32.f32 s14, s25
.Le2175:
.balign 4
.hword (.Le2176 - .Lb2176) / 2, 0
.Lb2176:
vcvt.s32.f32 s21, s13
.Le2176:
.balign 4
.hword (.Le2177 - .Lb2177) / 2, 0
.Lb2177:
vcvt.s32.f32 s6, s15
.Le2177:
.balign 4
.hword (.Le2178 - .Lb2178) / 2, 0
.Lb2178:
vcvt.s32.f32 s22, s28
.Le2178:
.balign 4
.hword (.Le2179 - .Lb2179) / 2, 0
.Lb2179:
vcvt.s32.f32 s25, s0
.Le2179:
.balign 4
.hword (.Le2180 - .Lb2180) / 2, 0
.Lb2180:
vcvt.s32.f32 s26, s9
.Le2180:
.balign 4
.hword (.Le2181 - .Lb2181) / 2, 0
.Lb2181:
vcvt.s32.f32 s20, s13
.Le2181:
.balign 4
.hword (.Le2182 - .Lb2182) / 2, 0
.Lb2182:
vcvt.s32.f32 s24, s25
.Le2182:
.balign 4
.hword (.Le2183 - .Lb2183) / 2, 0
.Lb2183:
vcvt.s32.f32 s5, s13
.Le2183:
.balign 4
.hword (.Le2184 - .Lb2184) / 2, 0
.Lb2184:
vcvt.s32.f32 s7, s24
.Le2184:
.balign 4
.hword (.Le2185 - .Lb2185) / 2, 0
.Lb2185:
vcvt.s32.f32 s7, s15
.Le2185:
.balign 4
.hword (.Le2186 - .Lb2186) / 2, 0
.Lb2186:
vcvt.s32.f32 s29, s5
.Le2186:
.balign 4
.hword (.Le2187 - .Lb2187) / 2, 0
.Lb2187:
vcvt.s32.f32 s10, s22
.Le2187:
.balign 4
.hword (.Le2188 - .Lb2188) / 2, 0
.Lb2188:
vcvt.s32.f32 s3, s8
.Le2188:
.balign 4
.hword (.Le2189 - .Lb2189) / 2, 0
.Lb2189:
vcvt.u32.f32 s31, s12
.Le2189:
.balign 4
.hword (.Le2190 - .Lb2190) / 2, 0
.Lb2190:
vcvt.u32.f32 s12, s21
.Le2190:
.balign 4
.hword (.Le2191 - .Lb2191) / 2, 0
.Lb2191:
vcvt.u32.f32 s12, s17
.Le2191:
.balign 4
.hword (.Le2192 - .Lb2192) / 2, 0
.Lb2192:
vcvt.u32.f32 s11, s26
.Le2192:
.balign 4
.hword (.Le2193 - .Lb2193) / 2, 0
.Lb2193:
vcvt.u32.f32 s3, s12
.Le2193:
.balign 4
.hword (.Le2194 - .Lb2194) / 2, 0
.Lb2194:
vcvt.u32.f32 s0, s26
.Le2194:
.balign 4
.hword (.Le2195 - .Lb2195) / 2, 0
.Lb2195:
vcvt.u32.f32 s4, s1
.Le2195:
.balign 4
.hword (.Le2196 - .Lb2196) / 2, 0
.Lb2196:
vcvt.u32.f32 s24, s9
.Le2196:
.balign 4
.hword (.Le2197 - .Lb2197) / 2, 0
.Lb2197:
vcvt.u32.f32 s18, s10
.Le2197:
.balign 4
.hword (.Le2198 - .Lb2198) / 2, 0
.Lb2198:
vcvt.u32.f32 s19, s19
.Le2198:
.balign 4
.hword (.Le2199 - .Lb2199) / 2, 0
.Lb2199:
vcvt.u32.f32 s28, s12
.Le2199:
.balign 4
.hword (.Le2200 - .Lb2200) / 2, 0
.Lb2200:
vcvt.u32.f32 s3, s24
.Le2200:
.balign 4
.hword (.Le2201 - .Lb2201) / 2, 0
.Lb2201:
vcvt.u32.f32 s20, s24
.Le2201:
.balign 4
.hword (.Le2202 - .Lb2202) / 2, 0
.Lb2202:
vcvt.u32.f32 s2, s5
.Le2202:
.balign 4
.hword (.Le2203 - .Lb2203) / 2, 0
.Lb2203:
vcvt.u32.f32 s10, s9
.Le2203:
.balign 4
.hword (.Le2204 - .Lb2204) / 2, 0
.Lb2204:
vcvt.u32.f32 s22, s11
.Le2204:
.balign 4
.hword (.Le2205 - .Lb2205) / 2, 0
.Lb2205:
vcvtr.s32.f32 s2, s29
.Le2205:
.balign 4
.hword (.Le2206 - .Lb2206) / 2, 0
.Lb2206:
vcvtr.s32.f32 s22, s22
.Le2206:
.balign 4
.hword (.Le2207 - .Lb2207) / 2, 0
.Lb2207:
vcvtr.s32.f32 s13, s15
.Le2207:
.balign 4
.hword (.Le2208 - .Lb2208) / 2, 0
.Lb2208:
vcvtr.s32.f32 s26, s15
.Le2208:
.balign 4
.hword (.Le2209 - .Lb2209) / 2, 0
.Lb2209:
vcvtr.s32.f32 s16, s29
.Le2209:
.balign 4
.hword (.Le2210 - .Lb2210) / 2, 0
.Lb2210:
vcvtr.s32.f32 s21, s1
.Le2210:
.balign 4
.hword (.Le2211 - .Lb2211) / 2, 0
.Lb2211:
vcvtr.s32.f32 s31, s8
.Le2211:
.balign 4
.hword (.Le2212 - .Lb2212) / 2, 0
.Lb2212:
vcvtr.s32.f32 s1, s24
.Le2212:
.balign 4
.hword (.Le2213 - .Lb2213) / 2, 0
.Lb2213:
vcvtr.s32.f32 s11, s24
.Le2213:
.balign 4
.hword (.Le2214 - .Lb2214) / 2, 0
.Lb2214:
vcvtr.s32.f32 s12, s1
.Le2214:
.balign 4
.hword (.Le2215 - .Lb2215) / 2, 0
.Lb2215:
vcvtr.s32.f32 s15, s21
.Le2215:
.balign 4
.hword (.Le2216 - .Lb2216) / 2, 0
.Lb2216:
vcvtr.s32.f32 s23, s19
.Le2216:
.balign 4
.hword (.Le2217 - .Lb2217) / 2, 0
.Lb2217:
vcvtr.s32.f32 s5, s20
.Le2217:
.balign 4
.hword (.Le2218 - .Lb2218) / 2, 0
.Lb2218:
vcvtr.s32.f32 s10, s3
.Le2218:
.balign 4
.hword (.Le2219 - .Lb2219) / 2, 0
.Lb2219:
vcvtr.s32.f32 s23, s15
.Le2219:
.balign 4
.hword (.Le2220 - .Lb2220) / 2, 0
.Lb2220:
vcvtr.s32.f32 s2, s0
.Le2220:
.balign 4
.hword (.Le2221 - .Lb2221) / 2, 0
.Lb2221:
vcvtr.u32.f32 s30, s29
.Le2221:
.balign 4
.hword (.Le2222 - .Lb2222) / 2, 0
.Lb2222:
vcvtr.u32.f32 s27, s25
.Le2222:
.balign 4
.hword (.Le2223 - .Lb2223) / 2, 0
.Lb2223:
vcvtr.u32.f32 s11, s15
.Le2223:
.balign 4
.hword (.Le2224 - .Lb2224) / 2, 0
.Lb2224:
vcvtr.u32.f32 s18, s14
.Le2224:
.balign 4
.hword (.Le2225 - .Lb2225) / 2, 0
.Lb2225:
vcvtr.u32.f32 s1, s13
.Le2225:
.balign 4
.hword (.Le2226 - .Lb2226) / 2, 0
.Lb2226:
vcvtr.u32.f32 s27, s31
.Le2226:
.balign 4
.hword (.Le2227 - .Lb2227) / 2, 0
.Lb2227:
vcvtr.u32.f32 s17, s7
.Le2227:
.balign 4
.hword (.Le2228 - .Lb2228) / 2, 0
.Lb2228:
vcvtr.u32.f32 s29, s17
.Le2228:
.balign 4
.hword (.Le2229 - .Lb2229) / 2, 0
.Lb2229:
vcvtr.u32.f32 s20, s21
.Le2229:
.balign 4
.hword (.Le2230 - .Lb2230) / 2, 0
.Lb2230:
vcvtr.u32.f32 s2, s12
.Le2230:
.balign 4
.hword (.Le2231 - .Lb2231) / 2, 0
.Lb2231:
vcvtr.u32.f32 s16, s14
.Le2231:
.balign 4
.hword (.Le2232 - .Lb2232) / 2, 0
.Lb2232:
vcvtr.u32.f32 s0, s29
.Le2232:
.balign 4
.hword (.Le2233 - .Lb2233) / 2, 0
.Lb2233:
vcvtr.u32.f32 s7, s27
.Le2233:
.balign 4
.hword (.Le2234 - .Lb2234) / 2, 0
.Lb2234:
vcvtr.u32.f32 s22, s2
.Le2234:
.balign 4
.hword (.Le2235 - .Lb2235) / 2, 0
.Lb2235:
vcvtr.u32.f32 s8, s23
.Le2235:
.balign 4
.hword (.Le2236 - .Lb2236) / 2, 0
.Lb2236:
vcvtr.u32.f32 s21, s11
.Le2236:
.balign 4
.hword 0xffff, 0
.balign 4
group_vcvt_fixed_s16:
.balign 4
.hword (.Le2237 - .Lb2237) / 2, 0
.Lb2237:
vcvt.f32.s16 s3, s3, #1
.Le2237:
.balign 4
.hword (.Le2238 - .Lb2238) / 2, 0
.Lb2238:
vcvt.f32.s16 s10, s10, #1
.Le2238:
.balign 4
.hword (.Le2239 - .Lb2239) / 2, 0
.Lb2239:
vcvt.f32.s16 s10, s10, #1
.Le2239:
.balign 4
.hword (.Le2240 - .Lb2240) / 2, 0
.Lb2240:
vcvt.f32.s16 s7, s7, #7
.Le2240:
.balign 4
.hword (.Le2241 - .Lb2241) / 2, 0
.Lb2241:
vcvt.f32.s16 s29, s29, #7
.Le2241:
.balign 4
.hword (.Le2242 - .Lb2242) / 2, 0
.Lb2242:
vcvt.f32.s16 s31, s31, #7
.Le2242:
.balign 4
.hword (.Le2243 - .Lb2243) / 2, 0
.Lb2243:
vcvt.f32.s16 s1, s1, #15
.Le2243:
.balign 4
.hword (.Le2244 - .Lb2244) / 2, 0
.Lb2244:
vcvt.f32.s16 s15, s15, #15
.Le2244:
.balign 4
.hword (.Le2245 - .Lb2245) / 2, 0
.Lb2245:
vcvt.f32.s16 s26, s26, #15
.Le2245:
.balign 4
.hword (.Le2246 - .Lb2246) / 2, 0
.Lb2246:
vcvt.f32.s16 s22, s22, #16
.Le2246:
.balign 4
.hword (.Le2247 - .Lb2247) / 2, 0
.Lb2247:
vcvt.f32.s16 s2, s2, #16
.Le2247:
.balign 4
.hword (.Le2248 - .Lb2248) / 2, 0
.Lb2248:
vcvt.f32.s16 s14, s14, #16
.Le2248:
.balign 4
.hword (.Le2249 - .Lb2249) / 2, 0
.Lb2249:
vcvt.s16.f32 s16, s16, #1
.Le2249:
.balign 4
.hword (.Le2250 - .Lb2250) / 2, 0
.Lb2250:
vcvt.s16.f32 s16, s16, #1
.Le2250:
.balign 4
.hword (.Le2251 - .Lb2251) / 2, 0
.Lb2251:
vcvt.s16.f32 s18, s18, #1
.Le2251:
.balign 4
.hword (.Le2252 - .Lb2252) / 2, 0
.Lb2252:
vcvt.s16.f32 s10, s10, #7
.Le2252:
.balign 4
.hword (.Le2253 - .Lb2253) / 2, 0
.Lb2253:
vcvt.s16.f32 s3, s3, #7
.Le2253:
.balign 4
.hword (.Le2254 - .Lb2254) / 2, 0
.Lb2254:
vcvt.s16.f32 s4, s4, #7
.Le2254:
.balign 4
.hword (.Le2255 - .Lb2255) / 2, 0
.Lb2255:
vcvt.s16.f32 s9, s9, #15
.Le2255:
.balign 4
.hword (.Le2256 - .Lb2256) / 2, 0
.Lb2256:
vcvt.s16.f32 s12, s12, #15
.Le2256:
.balign 4
.hword (.Le2257 - .Lb2257) / 2, 0
.Lb2257:
vcvt.s16.f32 s0, s0, #15
.Le2257:
.balign 4
.hword (.Le2258 - .Lb2258) / 2, 0
.Lb2258:
vcvt.s16.f32 s1, s1, #16
.Le2258:
.balign 4
.hword (.Le2259 - .Lb2259) / 2, 0
.Lb2259:
vcvt.s16.f32 s23, s23, #16
.Le2259:
.balign 4
.hword (.Le2260 - .Lb2260) / 2, 0
.Lb2260:
vcvt.s16.f32 s10, s10, #16
.Le2260:
.balign 4
.hword 0xffff, 0
.balign 4
group_vcvt_fixed_u16:
.balign 4
.hword (.Le2261 - .Lb2261) / 2, 0
.Lb2261:
vcvt.f32.u16 s2, s2, #1
.Le2261:
.balign 4
.hword (.Le2262 - .Lb2262) / 2, 0
.Lb2262:
vcvt.f32.u16 s25, s25, #1
.Le2262:
.balign 4
.hword (.Le2263 - .Lb2263) / 2, 0
.Lb2263:
vcvt.f32.u16 s23, s23, #1
.Le2263:
.balign 4
.hword (.Le2264 - .Lb2264) / 2, 0
.Lb2264:
vcvt.f32.u16 s6, s6, #7
.Le2264:
.balign 4
.hword (.Le2265 - .Lb2265) / 2, 0
.Lb2265:
vcvt.f32.u16 s0, s0, #7
.Le2265:
.balign 4
.hword (.Le2266 - .Lb2266) / 2, 0
.Lb2266:
vcvt.f32.u16 s25, s25, #7
.Le2266:
.balign 4
.hword (.Le2267 - .Lb2267) / 2, 0
.Lb2267:
vcvt.f32.u16 s24, s24, #15
.Le2267:
.balign 4
.hword (.Le2268 - .Lb2268) / 2, 0
.Lb2268:
vcvt.f32.u16 s18, s18, #15
.Le2268:
.balign 4
.hword (.Le2269 - .Lb2269) / 2, 0
.Lb2269:
vcvt.f32.u16 s31, s31, #15
.Le2269:
.balign 4
.hword (.Le2270 - .Lb2270) / 2, 0
.Lb2270:
vcvt.f32.u16 s3, s3, #16
.Le2270:
.balign 4
.hword (.Le2271 - .Lb2271) / 2, 0
.Lb2271:
vcvt.f32.u16 s27, s27, #16
.Le2271:
.balign 4
.hword (.Le2272 - .Lb2272) / 2, 0
.Lb2272:
vcvt.f32.u16 s21, s21, #16
.Le2272:
.balign 4
.hword (.Le2273 - .Lb2273) / 2, 0
.Lb2273:
vcvt.u16.f32 s31, s31, #1
.Le2273:
.balign 4
.hword (.Le2274 - .Lb2274) / 2, 0
.Lb2274:
vcvt.u16.f32 s0, s0, #1
.Le2274:
.balign 4
.hword (.Le2275 - .Lb2275) / 2, 0
.Lb2275:
vcvt.u16.f32 s23, s23, #1
.Le2275:
.balign 4
.hword (.Le2276 - .Lb2276) / 2, 0
.Lb2276:
vcvt.u16.f32 s8, s8, #7
.Le2276:
.balign 4
.hword (.Le2277 - .Lb2277) / 2, 0
.Lb2277:
vcvt.u16.f32 s3, s3, #7
.Le2277:
.balign 4
.hword (.Le2278 - .Lb2278) / 2, 0
.Lb2278:
vcvt.u16.f32 s21, s21, #7
.Le2278:
.balign 4
.hword (.Le2279 - .Lb2279) / 2, 0
.Lb2279:
vcvt.u16.f32 s8, s8, #15
.Le2279:
.balign 4
.hword (.Le2280 - .Lb2280) / 2, 0
.Lb2280:
vcvt.u16.f32 s20, s20, #15
.Le2280:
.balign 4
.hword (.Le2281 - .Lb2281) / 2, 0
.Lb2281:
vcvt.u16.f32 s28, s28, #15
.Le2281:
.balign 4
.hword (.Le2282 - .Lb2282) / 2, 0
.Lb2282:
vcvt.u16.f32 s23, s23, #16
.Le2282:
.balign 4
.hword (.Le2283 - .Lb2283) / 2, 0
.Lb2283:
vcvt.u16.f32 s11, s11, #16
.Le2283:
.balign 4
.hword (.Le2284 - .Lb2284) / 2, 0
.Lb2284:
vcvt.u16.f32 s11, s11, #16
.Le2284:
.balign 4
.hword 0xffff, 0
.balign 4
group_vcvt_fixed_s32:
.balign 4
.hword (.Le2285 - .Lb2285) / 2, 0
.Lb2285:
vcvt.f32.s32 s9, s9, #1
.Le2285:
.balign 4
.hword (.Le2286 - .Lb2286) / 2, 0
.Lb2286:
vcvt.f32.s32 s13, s13, #1
.Le2286:
.balign 4
.hword (.Le2287 - .Lb2287) / 2, 0
.Lb2287:
vcvt.f32.s32 s27, s27, #1
.Le2287:
.balign 4
.hword (.Le2288 - .Lb2288) / 2, 0
.Lb2288:
vcvt.f32.s32 s28, s28, #7
.Le2288:
.balign 4
.hword (.Le2289 - .Lb2289) / 2, 0
.Lb2289:
vcvt.f32.s32 s21, s21, #7
.Le2289:
.balign 4
.hword (.Le2290 - .Lb2290) / 2, 0
.Lb2290:
vcvt.f32.s32 s14, s14, #7
.Le2290:
.balign 4
.hword (.Le2291 - .Lb2291) / 2, 0
.Lb2291:
vcvt.f32.s32 s7, s7, #16
.Le2291:
.balign 4
.hword (.Le2292 - .Lb2292) / 2, 0
.Lb2292:
vcvt.f32.s32 s25, s25, #16
.Le2292:
.balign 4
.hword (.Le2293 - .Lb2293) / 2, 0
.Lb2293:
vcvt.f32.s32 s14, s14, #16
.Le2293:
.balign 4
.hword (.Le2294 - .Lb2294) / 2, 0
.Lb2294:
vcvt.f32.s32 s9, s9, #31
.Le2294:
.balign 4
.hword (.Le2295 - .Lb2295) / 2, 0
.Lb2295:
vcvt.f32.s32 s28, s28, #31
.Le2295:
.balign 4
.hword (.Le2296 - .Lb2296) / 2, 0
.Lb2296:
vcvt.f32.s32 s30, s30, #31
.Le2296:
.balign 4
.hword (.Le2297 - .Lb2297) / 2, 0
.Lb2297:
vcvt.f32.s32 s15, s15, #32
.Le2297:
.balign 4
.hword (.Le2298 - .Lb2298) / 2, 0
.Lb2298:
vcvt.f32.s32 s30, s30, #32
.Le2298:
.balign 4
.hword (.Le2299 - .Lb2299) / 2, 0
.Lb2299:
vcvt.f32.s32 s5, s5, #32
.Le2299:
.balign 4
.hword (.Le2300 - .Lb2300) / 2, 0
.Lb2300:
vcvt.s32.f32 s8, s8, #1
.Le2300:
.balign 4
.hword (.Le2301 - .Lb2301) / 2, 0
.Lb2301:
vcvt.s32.f32 s5, s5, #1
.Le2301:
.balign 4
.hword (.Le2302 - .Lb2302) / 2, 0
.Lb2302:
vcvt.s32.f32 s11, s11, #1
.Le2302:
.balign 4
.hword (.Le2303 - .Lb2303) / 2, 0
.Lb2303:
vcvt.s32.f32 s3, s3, #7
.Le2303:
.balign 4
.hword (.Le2304 - .Lb2304) / 2, 0
.Lb2304:
vcvt.s32.f32 s30, s30, #7
.Le2304:
.balign 4
.hword (.Le2305 - .Lb2305) / 2, 0
.Lb2305:
vcvt.s32.f32 s29, s29, #7
.Le2305:
.balign 4
.hword (.Le2306 - .Lb2306) / 2, 0
.Lb2306:
vcvt.s32.f32 s17, s17, #16
.Le2306:
.balign 4
.hword (.Le2307 - .Lb2307) / 2, 0
.Lb2307:
vcvt.s32.f32 s5, s5, #16
.Le2307:
.balign 4
.hword (.Le2308 - .Lb2308) / 2, 0
.Lb2308:
vcvt.s32.f32 s11, s11, #16
.Le2308:
.balign 4
.hword (.Le2309 - .Lb2309) / 2, 0
.Lb2309:
vcvt.s32.f32 s25, s25, #31
.Le2309:
.balign 4
.hword (.Le2310 - .Lb2310) / 2, 0
.Lb2310:
vcvt.s32.f32 s9, s9, #31
.Le2310:
.balign 4
.hword (.Le2311 - .Lb2311) / 2, 0
.Lb2311:
vcvt.s32.f32 s22, s22, #31
.Le2311:
.balign 4
.hword (.Le2312 - .Lb2312) / 2, 0
.Lb2312:
vcvt.s32.f32 s11, s11, #32
.Le2312:
.balign 4
.hword (.Le2313 - .Lb2313) / 2, 0
.Lb2313:
vcvt.s32.f32 s19, s19, #32
.Le2313:
.balign 4
.hword (.Le2314 - .Lb2314) / 2, 0
.Lb2314:
vcvt.s32.f32 s20, s20, #32
.Le2314:
.balign 4
.hword 0xffff, 0
.balign 4
group_vcvt_fixed_u32:
.balign 4
.hword (.Le2315 - .Lb2315) / 2, 0
.Lb2315:
vcvt.f32.u32 s28, s28, #1
.Le2315:
.balign 4
.hword (.Le2316 - .Lb2316) / 2, 0
.Lb2316:
vcvt.f32.u32 s29, s29, #1
.Le2316:
.balign 4
.hword (.Le2317 - .Lb2317) / 2, 0
.Lb2317:
vcvt.f32.u32 s17, s17, #1
.Le2317:
.balign 4
.hword (.Le2318 - .Lb2318) / 2, 0
.Lb2318:
vcvt.f32.u32 s2, s2, #7
.Le2318:
.balign 4
.hword (.Le2319 - .Lb2319) / 2, 0
.Lb2319:
vcvt.f32.u32 s31, s31, #7
.Le2319:
.balign 4
.hword (.Le2320 - .Lb2320) / 2, 0
.Lb2320:
vcvt.f32.u32 s7, s7, #7
.Le2320:
.balign 4
.hword (.Le2321 - .Lb2321) / 2, 0
.Lb2321:
vcvt.f32.u32 s14, s14, #16
.Le2321:
.balign 4
.hword (.Le2322 - .Lb2322) / 2, 0
.Lb2322:
vcvt.f32.u32 s4, s4, #16
.Le2322:
.balign 4
.hword (.Le2323 - .Lb2323) / 2, 0
.Lb2323:
vcvt.f32.u32 s16, s16, #16
.Le2323:
.balign 4
.hword (.Le2324 - .Lb2324) / 2, 0
.Lb2324:
vcvt.f32.u32 s15, s15, #31
.Le2324:
.balign 4
.hword (.Le2325 - .Lb2325) / 2, 0
.Lb2325:
vcvt.f32.u32 s16, s16, #31
.Le2325:
.balign 4
.hword (.Le2326 - .Lb2326) / 2, 0
.Lb2326:
vcvt.f32.u32 s8, s8, #31
.Le2326:
.balign 4
.hword (.Le2327 - .Lb2327) / 2, 0
.Lb2327:
vcvt.f32.u32 s20, s20, #32
.Le2327:
.balign 4
.hword (.Le2328 - .Lb2328) / 2, 0
.Lb2328:
vcvt.f32.u32 s5, s5, #32
.Le2328:
.balign 4
.hword (.Le2329 - .Lb2329) / 2, 0
.Lb2329:
vcvt.f32.u32 s27, s27, #32
.Le2329:
.balign 4
.hword (.Le2330 - .Lb2330) / 2, 0
.Lb2330:
vcvt.u32.f32 s16, s16, #1
.Le2330:
.balign 4
.hword (.Le2331 - .Lb2331) / 2, 0
.Lb2331:
vcvt.u32.f32 s24, s24, #1
.Le2331:
.balign 4
.hword (.Le2332 - .Lb2332) / 2, 0
.Lb2332:
vcvt.u32.f32 s3, s3, #1
.Le2332:
.balign 4
.hword (.Le2333 - .Lb2333) / 2, 0
.Lb2333:
vcvt.u32.f32 s22, s22, #7
.Le2333:
.balign 4
.hword (.Le2334 - .Lb2334) / 2, 0
.Lb2334:
vcvt.u32.f32 s11, s11, #7
.Le2334:
.balign 4
.hword (.Le2335 - .Lb2335) / 2, 0
.Lb2335:
vcvt.u32.f32 s13, s13, #7
.Le2335:
.balign 4
.hword (.Le2336 - .Lb2336) / 2, 0
.Lb2336:
vcvt.u32.f32 s21, s21, #16
.Le2336:
.balign 4
.hword (.Le2337 - .Lb2337) / 2, 0
.Lb2337:
vcvt.u32.f32 s17, s17, #16
.Le2337:
.balign 4
.hword (.Le2338 - .Lb2338) / 2, 0
.Lb2338:
vcvt.u32.f32 s5, s5, #16
.Le2338:
.balign 4
.hword (.Le2339 - .Lb2339) / 2, 0
.Lb2339:
vcvt.u32.f32 s15, s15, #31
.Le2339:
.balign 4
.hword (.Le2340 - .Lb2340) / 2, 0
.Lb2340:
vcvt.u32.f32 s7, s7, #31
.Le2340:
.balign 4
.hword (.Le2341 - .Lb2341) / 2, 0
.Lb2341:
vcvt.u32.f32 s7, s7, #31
.Le2341:
.balign 4
.hword (.Le2342 - .Lb2342) / 2, 0
.Lb2342:
vcvt.u32.f32 s14, s14, #32
.Le2342:
.balign 4
.hword (.Le2343 - .Lb2343) / 2, 0
.Lb2343:
vcvt.u32.f32 s14, s14, #32
.Le2343:
.balign 4
.hword (.Le2344 - .Lb2344) / 2, 0
.Lb2344:
vcvt.u32.f32 s30, s30, #32
.Le2344:
.balign 4
.hword 0xffff, 0
.balign 4
group_vcvt_half:
.balign 4
.hword (.Le2345 - .Lb2345) / 2, 0
.Lb2345:
vcvtb.f32.f16 s1, s24
.Le2345:
.balign 4
.hword (.Le2346 - .Lb2346) / 2, 0
.Lb2346:
vcvtb.f32.f16 s15, s9
.Le2346:
.balign 4
.hword (.Le2347 - .Lb2347) / 2, 0
.Lb2347:
vcvtb.f32.f16 s28, s30
.Le2347:
.balign 4
.hword (.Le2348 - .Lb2348) / 2, 0
.Lb2348:
vcvtb.f32.f16 s16, s4
.Le2348:
.balign 4
.hword (.Le2349 - .Lb2349) / 2, 0
.Lb2349:
vcvtb.f32.f16 s7, s7
.Le2349:
.balign 4
.hword (.Le2350 - .Lb2350) / 2, 0
.Lb2350:
vcvtb.f32.f16 s17, s2
.Le2350:
.balign 4
.hword (.Le2351 - .Lb2351) / 2, 0
.Lb2351:
vcvtb.f32.f16 s5, s4
.Le2351:
.balign 4
.hword (.Le2352 - .Lb2352) / 2, 0
.Lb2352:
vcvtb.f32.f16 s25, s30
.Le2352:
.balign 4
.hword (.Le2353 - .Lb2353) / 2, 0
.Lb2353:
vcvtb.f32.f16 s10, s2
.Le2353:
.balign 4
.hword (.Le2354 - .Lb2354) / 2, 0
.Lb2354:
vcvtb.f32.f16 s16, s25
.Le2354:
.balign 4
.hword (.Le2355 - .Lb2355) / 2, 0
.Lb2355:
vcvtb.f32.f16 s24, s0
.Le2355:
.balign 4
.hword (.Le2356 - .Lb2356) / 2, 0
.Lb2356:
vcvtb.f32.f16 s15, s4
.Le2356:
.balign 4
.hword (.Le2357 - .Lb2357) / 2, 0
.Lb2357:
vcvtb.f32.f16 s31, s13
.Le2357:
.balign 4
.hword (.Le2358 - .Lb2358) / 2, 0
.Lb2358:
vcvtb.f32.f16 s6, s12
.Le2358:
.balign 4
.hword (.Le2359 - .Lb2359) / 2, 0
.Lb2359:
vcvtb.f32.f16 s25, s27
.Le2359:
.balign 4
.hword (.Le2360 - .Lb2360) / 2, 0
.Lb2360:
vcvtb.f32.f16 s1, s1
.Le2360:
.balign 4
.hword (.Le2361 - .Lb2361) / 2, 0
.Lb2361:
vcvtt.f32.f16 s2, s26
.Le2361:
.balign 4
.hword (.Le2362 - .Lb2362) / 2, 0
.Lb2362:
vcvtt.f32.f16 s8, s12
.Le2362:
.balign 4
.hword (.Le2363 - .Lb2363) / 2, 0
.Lb2363:
vcvtt.f32.f16 s24, s5
.Le2363:
.balign 4
.hword (.Le2364 - .Lb2364) / 2, 0
.Lb2364:
vcvtt.f32.f16 s2, s9
.Le2364:
.balign 4
.hword (.Le2365 - .Lb2365) / 2, 0
.Lb2365:
vcvtt.f32.f16 s29, s19
.Le2365:
.balign 4
.hword (.Le2366 - .Lb2366) / 2, 0
.Lb2366:
vcvtt.f32.f16 s2, s18
.Le2366:
.balign 4
.hword (.Le2367 - .Lb2367) / 2, 0
.Lb2367:
vcvtt.f32.f16 s2, s18
.Le2367:
.balign 4
.hword (.Le2368 - .Lb2368) / 2, 0
.Lb2368:
vcvtt.f32.f16 s2, s5
.Le2368:
.balign 4
.hword (.Le2369 - .Lb2369) / 2, 0
.Lb2369:
vcvtt.f32.f16 s10, s31
.Le2369:
.balign 4
.hword (.Le2370 - .Lb2370) / 2, 0
.Lb2370:
vcvtt.f32.f16 s16, s1
.Le2370:
.balign 4
.hword (.Le2371 - .Lb2371) / 2, 0
.Lb2371:
vcvtt.f32.f16 s26, s18
.Le2371:
.balign 4
.hword (.Le2372 - .Lb2372) / 2, 0
.Lb2372:
vcvtt.f32.f16 s3, s12
.Le2372:
.balign 4
.hword (.Le2373 - .Lb2373) / 2, 0
.Lb2373:
vcvtt.f32.f16 s21, s15
.Le2373:
.balign 4
.hword (.Le2374 - .Lb2374) / 2, 0
.Lb2374:
vcvtt.f32.f16 s8, s2
.Le2374:
.balign 4
.hword (.Le2375 - .Lb2375) / 2, 0
.Lb2375:
vcvtt.f32.f16 s6, s19
.Le2375:
.balign 4
.hword (.Le2376 - .Lb2376) / 2, 0
.Lb2376:
vcvtt.f32.f16 s20, s30
.Le2376:
.balign 4
.hword (.Le2377 - .Lb2377) / 2, 0
.Lb2377:
vcvtb.f16.f32 s1, s24
.Le2377:
.balign 4
.hword (.Le2378 - .Lb2378) / 2, 0
.Lb2378:
vcvtb.f16.f32 s15, s6
.Le2378:
.balign 4
.hword (.Le2379 - .Lb2379) / 2, 0
.Lb2379:
vcvtb.f16.f32 s26, s14
.Le2379:
.balign 4
.hword (.Le2380 - .Lb2380) / 2, 0
.Lb2380:
vcvtb.f16.f32 s0, s26
.Le2380:
.balign 4
.hword (.Le2381 - .Lb2381) / 2, 0
.Lb2381:
vcvtb.f16.f32 s24, s8
.Le2381:
.balign 4
.hword (.Le2382 - .Lb2382) / 2, 0
.Lb2382:
vcvtb.f16.f32 s27, s7
.Le2382:
.balign 4
.hword (.Le2383 - .Lb2383) / 2, 0
.Lb2383:
vcvtb.f16.f32 s7, s11
.Le2383:
.balign 4
.hword (.Le2384 - .Lb2384) / 2, 0
.Lb2384:
vcvtb.f16.f32 s22, s31
.Le2384:
.balign 4
.hword (.Le2385 - .Lb2385) / 2, 0
.Lb2385:
vcvtb.f16.f32 s10, s15
.Le2385:
.balign 4
.hword (.Le2386 - .Lb2386) / 2, 0
.Lb2386:
vcvtb.f16.f32 s16, s20
.Le2386:
.balign 4
.hword (.Le2387 - .Lb2387) / 2, 0
.Lb2387:
vcvtb.f16.f32 s15, s16
.Le2387:
.balign 4
.hword (.Le2388 - .Lb2388) / 2, 0
.Lb2388:
vcvtb.f16.f32 s10, s3
.Le2388:
.balign 4
.hword (.Le2389 - .Lb2389) / 2, 0
.Lb2389:
vcvtb.f16.f32 s29, s8
.Le2389:
.balign 4
.hword (.Le2390 - .Lb2390) / 2, 0
.Lb2390:
vcvtb.f16.f32 s15, s2
.Le2390:
.balign 4
.hword (.Le2391 - .Lb2391) / 2, 0
.Lb2391:
vcvtb.f16.f32 s27, s31
.Le2391:
.balign 4
.hword (.Le2392 - .Lb2392) / 2, 0
.Lb2392:
vcvtb.f16.f32 s3, s24
.Le2392:
.balign 4
.hword (.Le2393 - .Lb2393) / 2, 0
.Lb2393:
vcvtt.f16.f32 s31, s19
.Le2393:
.balign 4
.hword (.Le2394 - .Lb2394) / 2, 0
.Lb2394:
vcvtt.f16.f32 s17, s22
.Le2394:
.balign 4
.hword (.Le2395 - .Lb2395) / 2, 0
.Lb2395:
vcvtt.f16.f32 s23, s27
.Le2395:
.balign 4
.hword (.Le2396 - .Lb2396) / 2, 0
.Lb2396:
vcvtt.f16.f32 s15, s6
.Le2396:
.balign 4
.hword (.Le2397 - .Lb2397) / 2, 0
.Lb2397:
vcvtt.f16.f32 s22, s4
.Le2397:
.balign 4
.hword (.Le2398 - .Lb2398) / 2, 0
.Lb2398:
vcvtt.f16.f32 s23, s2
.Le2398:
.balign 4
.hword (.Le2399 - .Lb2399) / 2, 0
.Lb2399:
vcvtt.f16.f32 s22, s24
.Le2399:
.balign 4
.hword (.Le2400 - .Lb2400) / 2, 0
.Lb2400:
vcvtt.f16.f32 s6, s0
.Le2400:
.balign 4
.hword (.Le2401 - .Lb2401) / 2, 0
.Lb2401:
vcvtt.f16.f32 s11, s6
.Le2401:
.balign 4
.hword (.Le2402 - .Lb2402) / 2, 0
.Lb2402:
vcvtt.f16.f32 s13, s4
.Le2402:
.balign 4
.hword (.Le2403 - .Lb2403) / 2, 0
.Lb2403:
vcvtt.f16.f32 s8, s11
.Le2403:
.balign 4
.hword (.Le2404 - .Lb2404) / 2, 0
.Lb2404:
vcvtt.f16.f32 s28, s17
.Le2404:
.balign 4
.hword (.Le2405 - .Lb2405) / 2, 0
.Lb2405:
vcvtt.f16.f32 s30, s23
.Le2405:
.balign 4
.hword (.Le2406 - .Lb2406) / 2, 0
.Lb2406:
vcvtt.f16.f32 s9, s8
.Le2406:
.balign 4
.hword (.Le2407 - .Lb2407) / 2, 0
.Lb2407:
vcvtt.f16.f32 s4, s10
.Le2407:
.balign 4
.hword (.Le2408 - .Lb2408) / 2, 0
.Lb2408:
vcvtt.f16.f32 s11, s18
.Le2408:
.balign 4
.hword 0xffff, 0
.balign 4
group_vload:
.balign 4
.hword (.Le2409 - .Lb2409) / 2, 0
.Lb2409:
vldr s0, [r7, #0]
.Le2409:
.balign 4
.hword (.Le2410 - .Lb2410) / 2, 0
.Lb2410:
vldr s31, [r7, #60]
.Le2410:
.balign 4
.hword (.Le2411 - .Lb2411) / 2, 0
.Lb2411:
vldr s7, [r7, #-32]
.Le2411:
.balign 4
.hword (.Le2412 - .Lb2412) / 2, 0
.Lb2412:
vldr d0, [r7, #0]
.Le2412:
.balign 4
.hword (.Le2413 - .Lb2413) / 2, 0
.Lb2413:
vldr d15, [r7, #32]
.Le2413:
.balign 4
.hword (.Le2414 - .Lb2414) / 2, 0
.Lb2414:
vldr d7, [r7, #-32]
.Le2414:
.balign 4
.hword (.Le2415 - .Lb2415) / 2, 0
.Lb2415:
vldmia r7, {s0}
.Le2415:
.balign 4
.hword (.Le2416 - .Lb2416) / 2, 0
.Lb2416:
vldmia r7, {s3-s9}
.Le2416:
.balign 4
.hword (.Le2417 - .Lb2417) / 2, 0
.Lb2417:
vldmia r7, {d2-d4}
.Le2417:
.balign 4
.hword (.Le2418 - .Lb2418) / 2, 0
.Lb2418:
vldmia r7, {s31}
.Le2418:
.balign 4
.hword (.Le2419 - .Lb2419) / 2, 0
.Lb2419:
vldmia r7!, {s0}
.Le2419:
.balign 4
.hword (.Le2420 - .Lb2420) / 2, 0
.Lb2420:
vldmia r7!, {s3-s9}
.Le2420:
.balign 4
.hword (.Le2421 - .Lb2421) / 2, 0
.Lb2421:
vldmia r7!, {d2-d4}
.Le2421:
.balign 4
.hword (.Le2422 - .Lb2422) / 2, 0
.Lb2422:
vldmia r7!, {s31}
.Le2422:
.balign 4
.hword (.Le2423 - .Lb2423) / 2, 0
.Lb2423:
vldmdb r7!, {s0}
.Le2423:
.balign 4
.hword (.Le2424 - .Lb2424) / 2, 0
.Lb2424:
vldmdb r7!, {s3-s9}
.Le2424:
.balign 4
.hword (.Le2425 - .Lb2425) / 2, 0
.Lb2425:
vldmdb r7!, {d2-d4}
.Le2425:
.balign 4
.hword (.Le2426 - .Lb2426) / 2, 0
.Lb2426:
vldmdb r7!, {s31}
.Le2426:
.balign 4
.hword (.Le2427 - .Lb2427) / 2, 0
.Lb2427:
vpush {s0-s3}
vpop {s4-s7}
.Le2427:
.balign 4
.hword (.Le2428 - .Lb2428) / 2, 0
.Lb2428:
vpush {d8-d9}
vpop {d1-d2}
.Le2428:
.balign 4
.hword 0xffff, 0
.balign 4
group_vstore:
.balign 4
.hword (.Le2429 - .Lb2429) / 2, 0
.Lb2429:
vstr s0, [r7, #0]
.Le2429:
.balign 4
.hword (.Le2430 - .Lb2430) / 2, 0
.Lb2430:
vstr s31, [r7, #60]
.Le2430:
.balign 4
.hword (.Le2431 - .Lb2431) / 2, 0
.Lb2431:
vstr s7, [r7, #-32]
.Le2431:
.balign 4
.hword (.Le2432 - .Lb2432) / 2, 0
.Lb2432:
vstr d0, [r7, #0]
.Le2432:
.balign 4
.hword (.Le2433 - .Lb2433) / 2, 0
.Lb2433:
vstr d15, [r7, #32]
.Le2433:
.balign 4
.hword (.Le2434 - .Lb2434) / 2, 0
.Lb2434:
vstr d7, [r7, #-32]
.Le2434:
.balign 4
.hword (.Le2435 - .Lb2435) / 2, 0
.Lb2435:
vstmia r7, {s0}
.Le2435:
.balign 4
.hword (.Le2436 - .Lb2436) / 2, 0
.Lb2436:
vstmia r7, {s3-s9}
.Le2436:
.balign 4
.hword (.Le2437 - .Lb2437) / 2, 0
.Lb2437:
vstmia r7, {d2-d4}
.Le2437:
.balign 4
.hword (.Le2438 - .Lb2438) / 2, 0
.Lb2438:
vstmia r7, {s31}
.Le2438:
.balign 4
.hword (.Le2439 - .Lb2439) / 2, 0
.Lb2439:
vstmia r7!, {s0}
.Le2439:
.balign 4
.hword (.Le2440 - .Lb2440) / 2, 0
.Lb2440:
vstmia r7!, {s3-s9}
.Le2440:
.balign 4
.hword (.Le2441 - .Lb2441) / 2, 0
.Lb2441:
vstmia r7!, {d2-d4}
.Le2441:
.balign 4
.hword (.Le2442 - .Lb2442) / 2, 0
.Lb2442:
vstmia r7!, {s31}
.Le2442:
.balign 4
.hword (.Le2443 - .Lb2443) / 2, 0
.Lb2443:
vstmdb r7!, {s0}
.Le2443:
.balign 4
.hword (.Le2444 - .Lb2444) / 2, 0
.Lb2444:
vstmdb r7!, {s3-s9}
.Le2444:
.balign 4
.hword (.Le2445 - .Lb2445) / 2, 0
.Lb2445:
vstmdb r7!, {d2-d4}
.Le2445:
.balign 4
.hword (.Le2446 - .Lb2446) / 2, 0
.Lb2446:
vstmdb r7!, {s31}
.Le2446:
.balign 4
.hword 0xffff, 0
.balign 4
.global groups
groups:
.word .Ln_and_imm, 7, group_and_imm
.word .Ln_and_reg, 7, group_and_reg
.word .Ln_bic_imm, 7, group_bic_imm
.word .Ln_bic_reg, 7, group_bic_reg
.word .Ln_orr_imm, 7, group_orr_imm
.word .Ln_orr_reg, 7, group_orr_reg
.word .Ln_orn_imm, 7, group_orn_imm
.word .Ln_orn_reg, 7, group_orn_reg
.word .Ln_eor_imm, 7, group_eor_imm
.word .Ln_eor_reg, 7, group_eor_reg
.word .Ln_add_imm, 7, group_add_imm
.word .Ln_add_reg, 7, group_add_reg
.word .Ln_adc_imm, 7, group_adc_imm
.word .Ln_adc_reg, 7, group_adc_reg
.word .Ln_sbc_imm, 7, group_sbc_imm
.word .Ln_sbc_reg, 7, group_sbc_reg
.word .Ln_sub_imm, 7, group_sub_imm
.word .Ln_sub_reg, 7, group_sub_reg
.word .Ln_rsb_imm, 7, group_rsb_imm
.word .Ln_rsb_reg, 7, group_rsb_reg
.word .Ln_mov_imm, 7, group_mov_imm
.word .Ln_mov_reg, 7, group_mov_reg
.word .Ln_mvn_imm, 7, group_mvn_imm
.word .Ln_mvn_reg, 7, group_mvn_reg
.word .Ln_tst_imm, 7, group_tst_imm
.word .Ln_tst_reg, 7, group_tst_reg
.word .Ln_teq_imm, 7, group_teq_imm
.word .Ln_teq_reg, 7, group_teq_reg
.word .Ln_cmp_imm, 7, group_cmp_imm
.word .Ln_cmp_reg, 7, group_cmp_reg
.word .Ln_cmn_imm, 7, group_cmn_imm
.word .Ln_cmn_reg, 7, group_cmn_reg
.word .Ln_shift_wide_imm, 14, group_shift_wide_imm
.word .Ln_shift_wide_reg, 14, group_shift_wide_reg
.word .Ln_plain_imm, 9, group_plain_imm
.word .Ln_narrow_shift, 12, group_narrow_shift
.word .Ln_narrow_arithmetic, 17, group_narrow_arithmetic
.word .Ln_narrow_data, 11, group_narrow_data
.word .Ln_narrow_special, 14, group_narrow_special
.word .Ln_uxtb, 4, group_uxtb
.word .Ln_uxth, 4, group_uxth
.word .Ln_sxtb, 4, group_sxtb
.word .Ln_sxth, 4, group_sxth
.word .Ln_uxtb16, 6, group_uxtb16
.word .Ln_sxtb16, 6, group_sxtb16
.word .Ln_uxtab, 5, group_uxtab
.word .Ln_uxtah, 5, group_uxtah
.word .Ln_sxtab, 5, group_sxtab
.word .Ln_sxtah, 5, group_sxtah
.word .Ln_uxtab16, 7, group_uxtab16
.word .Ln_sxtab16, 7, group_sxtab16
.word .Ln_bitfield, 8, group_bitfield
.word .Ln_count_reverse, 13, group_count_reverse
.word .Ln_sel, 3, group_sel
.word .Ln_ssat, 4, group_ssat
.word .Ln_usat, 4, group_usat
.word .Ln_sat16, 5, group_sat16
.word .Ln_pkh, 3, group_pkh
.word .Ln_qadd, 4, group_qadd
.word .Ln_parallel_add8, 13, group_parallel_add8
.word .Ln_parallel_add16, 14, group_parallel_add16
.word .Ln_parallel_asx, 12, group_parallel_asx
.word .Ln_parallel_sax, 12, group_parallel_sax
.word .Ln_parallel_sub8, 13, group_parallel_sub8
.word .Ln_parallel_sub16, 14, group_parallel_sub16
.word .Ln_mul, 3, group_mul
.word .Ln_long_mul, 8, group_long_mul
.word .Ln_dsp16, 5, group_dsp16
.word .Ln_dsp_dual, 8, group_dsp_dual
.word .Ln_dsp_high, 8, group_dsp_high
.word .Ln_div, 3, group_div
.word .Ln_branch, 6, group_branch
.word .Ln_it, 2, group_it
.word .Ln_load_imm, 8, group_load_imm
.word .Ln_store_imm, 9, group_store_imm
.word .Ln_load_index, 10, group_load_index
.word .Ln_store_index, 11, group_store_index
.word .Ln_load_reg, 8, group_load_reg
.word .Ln_store_reg, 9, group_store_reg
.word .Ln_narrow_memory, 13, group_narrow_memory
.word .Ln_literal, 7, group_literal
.word .Ln_dual, 4, group_dual
.word .Ln_multiple, 8, group_multiple
.word .Ln_exclusive, 9, group_exclusive
.word .Ln_hints, 5, group_hints
.word .Ln_special, 7, group_special
.word .Ln_vadd, 4, group_vadd
.word .Ln_vsub, 4, group_vsub
.word .Ln_vmul, 4, group_vmul
.word .Ln_vnmul, 5, group_vnmul
.word .Ln_vdiv, 4, group_vdiv
.word .Ln_vmla, 4, group_vmla
.word .Ln_vmls, 4, group_vmls
.word .Ln_vnmla, 5, group_vnmla
.word .Ln_vnmls, 5, group_vnmls
.word .Ln_vfma, 4, group_vfma
.word .Ln_vfms, 4, group_vfms
.word .Ln_vfnma, 5, group_vfnma
.word .Ln_vfnms, 5, group_vfnms
.word .Ln_vabs, 4, group_vabs
.word .Ln_vneg, 4, group_vneg
.word .Ln_vsqrt, 5, group_vsqrt
.word .Ln_vcmp, 4, group_vcmp
.word .Ln_vcmp_zero, 9, group_vcmp_zero
.word .Ln_vmov, 4, group_vmov
.word .Ln_vcvt_int, 8, group_vcvt_int
.word .Ln_vcvt_fixed_s16, 14, group_vcvt_fixed_s16
.word .Ln_vcvt_fixed_u16, 14, group_vcvt_fixed_u16
.word .Ln_vcvt_fixed_s32, 14, group_vcvt_fixed_s32
.word .Ln_vcvt_fixed_u32, 14, group_vcvt_fixed_u32
.word .Ln_vcvt_half, 9, group_vcvt_half
.word .Ln_vload, 5, group_vload
.word .Ln_vstore, 6, group_vstore
.word 0, 0, 0
.Ln_and_imm: .ascii "and_imm"
.Ln_and_reg: .ascii "and_reg"
.Ln_bic_imm: .ascii "bic_imm"
.Ln_bic_reg: .ascii "bic_reg"
.Ln_orr_imm: .ascii "orr_imm"
.Ln_orr_reg: .ascii "orr_reg"
.Ln_orn_imm: .ascii "orn_imm"
.Ln_orn_reg: .ascii "orn_reg"
.Ln_eor_imm: .ascii "eor_imm"
.Ln_eor_reg: .ascii "eor_reg"
.Ln_add_imm: .ascii "add_imm"
.Ln_add_reg: .ascii "add_reg"
.Ln_adc_imm: .ascii "adc_imm"
.Ln_adc_reg: .ascii "adc_reg"
.Ln_sbc_imm: .ascii "sbc_imm"
.Ln_sbc_reg: .ascii "sbc_reg"
.Ln_sub_imm: .ascii "sub_imm"
.Ln_sub_reg: .ascii "sub_reg"
.Ln_rsb_imm: .ascii "rsb_imm"
.Ln_rsb_reg: .ascii "rsb_reg"
.Ln_mov_imm: .ascii "mov_imm"
.Ln_mov_reg: .ascii "mov_reg"
.Ln_mvn_imm: .ascii "mvn_imm"
.Ln_mvn_reg: .ascii "mvn_reg"
.Ln_tst_imm: .ascii "tst_imm"
.Ln_tst_reg: .ascii "tst_reg"
.Ln_teq_imm: .ascii "teq_imm"
.Ln_teq_reg: .ascii "teq_reg"
.Ln_cmp_imm: .ascii "cmp_imm"
.Ln_cmp_reg: .ascii "cmp_reg"
.Ln_cmn_imm: .ascii "cmn_imm"
.Ln_cmn_reg: .ascii "cmn_reg"
.Ln_shift_wide_imm: .ascii "shift_wide_imm"
.Ln_shift_wide_reg: .ascii "shift_wide_reg"
.Ln_plain_imm: .ascii "plain_imm"
.Ln_narrow_shift: .ascii "narrow_shift"
.Ln_narrow_arithmetic: .ascii "narrow_arithmetic"
.Ln_narrow_data: .ascii "narrow_data"
.Ln_narrow_special: .ascii "narrow_special"
.Ln_uxtb: .ascii "uxtb"
.Ln_uxth: .ascii "uxth"
.Ln_sxtb: .ascii "sxtb"
.Ln_sxth: .ascii "sxth"
.Ln_uxtb16: .ascii "uxtb16"
.Ln_sxtb16: .ascii "sxtb16"
.Ln_uxtab: .ascii "uxtab"
.Ln_uxtah: .ascii "uxtah"
.Ln_sxtab: .ascii "sxtab"
.Ln_sxtah: .ascii "sxtah"
.Ln_uxtab16: .ascii "uxtab16"
.Ln_sxtab16: .ascii "sxtab16"
.Ln_bitfield: .ascii "bitfield"
.Ln_count_reverse: .ascii "count_reverse"
.Ln_sel: .ascii "sel"
.Ln_ssat: .ascii "ssat"
.Ln_usat: .ascii "usat"
.Ln_sat16: .ascii "sat16"
.Ln_pkh: .ascii "pkh"
.Ln_qadd: .ascii "qadd"
.Ln_parallel_add8: .ascii "parallel_add8"
.Ln_parallel_add16: .ascii "parallel_add16"
.Ln_parallel_asx: .ascii "parallel_asx"
.Ln_parallel_sax: .ascii "parallel_sax"
.Ln_parallel_sub8: .ascii "parallel_sub8"
.Ln_parallel_sub16: .ascii "parallel_sub16"
.Ln_mul: .ascii "mul"
.Ln_long_mul: .ascii "long_mul"
.Ln_dsp16: .ascii "dsp16"
.Ln_dsp_dual: .ascii "dsp_dual"
.Ln_dsp_high: .ascii "dsp_high"
.Ln_div: .ascii "div"
.Ln_branch: .ascii "branch"
.Ln_it: .ascii "it"
.Ln_load_imm: .ascii "load_imm"
.Ln_store_imm: .ascii "store_imm"
.Ln_load_index: .ascii "load_index"
.Ln_store_index: .ascii "store_index"
.Ln_load_reg: .ascii "load_reg"
.Ln_store_reg: .ascii "store_reg"
.Ln_narrow_memory: .ascii "narrow_memory"
.Ln_literal: .ascii "literal"
.Ln_dual: .ascii "dual"
.Ln_multiple: .ascii "multiple"
.Ln_exclusive: .ascii "exclusive"
.Ln_hints: .ascii "hints"
.Ln_special: .ascii "special"
.Ln_vadd: .ascii "vadd"
.Ln_vsub: .ascii "vsub"
.Ln_vmul: .ascii "vmul"
.Ln_vnmul: .ascii "vnmul"
.Ln_vdiv: .ascii "vdiv"
.Ln_vmla: .ascii "vmla"
.Ln_vmls: .ascii "vmls"
.Ln_vnmla: .ascii "vnmla"
.Ln_vnmls: .ascii "vnmls"
.Ln_vfma: .ascii "vfma"
.Ln_vfms: .ascii "vfms"
.Ln_vfnma: .ascii "vfnma"
.Ln_vfnms: .ascii "vfnms"
.Ln_vabs: .ascii "vabs"
.Ln_vneg: .ascii "vneg"
.Ln_vsqrt: .ascii "vsqrt"
.Ln_vcmp: .ascii "vcmp"
.Ln_vcmp_zero: .ascii "vcmp_zero"
.Ln_vmov: .ascii "vmov"
.Ln_vcvt_int: .ascii "vcvt_int"
.Ln_vcvt_fixed_s16: .ascii "vcvt_fixed_s16"
.Ln_vcvt_fixed_u16: .ascii "vcvt_fixed_u16"
.Ln_vcvt_fixed_s32: .ascii "vcvt_fixed_s32"
.Ln_vcvt_fixed_u32: .ascii "vcvt_fixed_u32"
.Ln_vcvt_half: .ascii "vcvt_half"
.Ln_vload: .ascii "vload"
.Ln_vstore: .ascii "vstore"
