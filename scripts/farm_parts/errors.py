"""What may go wrong, with the exit codes of hazumi."""

FAILED, USAGE, BAD_DATA, NO_INPUT, CANNOT_WRITE, INTERRUPTED = 1, 2, 65, 66, 73, 130


class FarmError(Exception):
    """A message for the user, which says what to do, and the code to end with."""

    def __init__(self, message, code=FAILED):
        super().__init__(message)
        self.code = code
