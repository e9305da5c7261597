"""SDL2 through PySDL2, opened for joysticks alone: no window, no signals, no event queue."""

from __future__ import annotations

from typing import Any

from omnistudy.errors.handheld import CannotOpen, NoDriver

DEVICE = "sdl_stick"


def sdl() -> Any:
    """Give the module `sdl2`; raises NoDriver when it or the system's SDL2 is missing."""
    try:
        import sdl2
    except ModuleNotFoundError as cause:
        remedy = "pip install 'omnistudy[devices]'"
        raise NoDriver(DEVICE, "the Python package PySDL2", remedy) from cause
    except ImportError as cause:
        remedy = "apt-get install libsdl2-2.0-0, or `make system-packages`"
        raise NoDriver(DEVICE, "the system's library SDL2", remedy) from cause
    return sdl2


def start_sdl() -> Any:
    """Start SDL's joysticks and give the module; each start needs one `stop_sdl`.

    Raises NoDriver, CannotOpen.
    """
    library = sdl()
    for hint, value in (
        (library.SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, b"1"),
        (library.SDL_HINT_NO_SIGNAL_HANDLERS, b"1"),
    ):
        library.SDL_SetHint(hint, value)
    if library.SDL_InitSubSystem(_parts(library)) != 0:
        cause = library.SDL_GetError().decode()
        raise CannotOpen(DEVICE, "SDL2", cause, "see whether other programs find a joystick")
    # Nobody empties the queue of events: the state is asked for instead.
    library.SDL_JoystickEventState(library.SDL_IGNORE)
    library.SDL_GameControllerEventState(library.SDL_IGNORE)
    library.SDL_JoystickUpdate()
    return library


def stop_sdl(library: Any) -> None:
    """End what `start_sdl` started."""
    library.SDL_QuitSubSystem(_parts(library))


def _parts(library: Any) -> int:
    parts: int = (
        library.SDL_INIT_JOYSTICK | library.SDL_INIT_GAMECONTROLLER | library.SDL_INIT_HAPTIC
    )
    return parts
