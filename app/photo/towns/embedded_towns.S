// SPDX-License-Identifier: Apache-2.0
// resources/places/towns.tsv inside the program, so that no file is needed at run time. It starts at tp_towns and ends
// before tp_towns_end. ELF, GNU assembler.
    .section .rodata
    .globl tp_towns
tp_towns: .incbin "towns.tsv"
    .globl tp_towns_end
tp_towns_end:

#if defined(__linux__)
    .section .note.GNU-stack, "", %progbits
#endif
