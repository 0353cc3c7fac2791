"""other_program.py CLIENT TOKEN_FILE: the client of the live link meets programs that are no Tactus, and wrong words of its own.

It ends with a sentence each time, never with a traceback.
"""
import socket
import subprocess
import sys
import threading

ANSWERS = [b"HTTP/1.0 400 Bad Request\r\n\r\n", b"", b"{}\n", b"5\n", b"\xff\n"]


def answer_all(listening):
    for answer in ANSWERS:
        connection, _ = listening.accept()
        connection.recv(4096)
        connection.sendall(answer)
        connection.close()


def ends_with_a_sentence(port, point, status):
    said = subprocess.run([sys.executable, sys.argv[1], "--port", str(port), "--token-file", sys.argv[2], "--ask", point],
                          capture_output=True, text=True, timeout=60)
    if said.returncode != status or "wanted" not in said.stderr or "Traceback" in said.stderr:
        sys.exit(f"ended with {said.returncode}: {said.stdout}{said.stderr}")


with socket.create_server(("127.0.0.1", 0)) as listening:
    threading.Thread(target=answer_all, args=(listening,), daemon=True).start()
    for _ in ANSWERS:
        ends_with_a_sentence(listening.getsockname()[1], "1,45,30,30", 1)
ends_with_a_sentence(1, "0,5;45;30;30", 2)
