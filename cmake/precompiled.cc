// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0

// Only here to own precompiled headers; see ArmcalRooms.cmake.
