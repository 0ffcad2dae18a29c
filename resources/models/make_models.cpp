// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.h"
#include "step_writer.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Standard_Failure.hxx>
#include <cstdio>
#include <filesystem>

int main(int argc, char** argv)
{
    using namespace tapeline::models;
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_models FOLDER\nWrites Tapeline's sample models into FOLDER as STEP files.\n");
        return 1;
    }
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
    const std::filesystem::path folder = argv[1];
    try {
        std::filesystem::create_directories(folder);
        write_step(folder / "hood.step", hood(), "hood");
        write_step(folder / "wheel_arch.step", wheel_arch(), "wheel_arch");
        write_step(folder / "pawn.step", pawn(), "pawn");
        write_step(folder / "bracket.step", bracket(), "bracket");
        write_step(folder / "panel.step", panel(), "panel");
        write_step(folder / "door.step", door(), "door");
        write_step(folder / "filleted_panel.step", filleted_panel(), "filleted_panel");
    } catch (const Standard_Failure& failure) {
        std::fprintf(stderr, "make_models: %s\n", failure.GetMessageString());
        return 2;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "make_models: %s\n", failure.what());
        return 2;
    }
    return 0;
}
