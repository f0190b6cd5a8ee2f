// SPDX-License-Identifier: Apache-2.0
// The nets of resources/models inside the program, so that no file is needed at run time.
// Each starts at tp_model_<name> and ends before tp_model_<name>_end. ELF, GNU assembler.
#define MODEL(name, file)                                                                                    \
    .balign 64;                                                                                              \
    .globl tp_model_##name;                                                                                  \
    tp_model_##name: .incbin file;                                                                           \
    .globl tp_model_##name##_end;                                                                            \
    tp_model_##name##_end:

    .section .rodata
    MODEL(detector, "detector.onnx")
    MODEL(contours, "contours.onnx")
    MODEL(eye, "eye.onnx")
    MODEL(mouth, "mouth.onnx")
    MODEL(outline, "outline.onnx")
    MODEL(dark_glasses, "dark_glasses.onnx")
    MODEL(hidden_jaw, "hidden_jaw.onnx")
    MODEL(mesh, "mesh.onnx")
    MODEL(yunet, "yunet.onnx")
    MODEL(descriptor, "descriptor.packed")

#if defined(__linux__)
    .section .note.GNU-stack, "", %progbits
#endif
