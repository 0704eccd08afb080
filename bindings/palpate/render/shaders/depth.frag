// SPDX-License-Identifier: BSD-3-Clause
#version 330 core

void main() {}
