"""Lets through only what may be answered, before anything looks at it."""

from __future__ import annotations

from starlette.datastructures import Headers
from starlette.responses import HTMLResponse, RedirectResponse
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocketClose

from omnistudy.view.access import Access, Asked, cookie_name, without_token
from omnistudy.view.page import saying_page

POLICY = (
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; "
    "form-action 'none'"
)
"""Pages hold everything they need, ask nobody else and stand in nobody's frame."""

HEADERS = {
    "content-security-policy": POLICY,
    "referrer-policy": "no-referrer",
    "x-content-type-options": "nosniff",
    "cache-control": "no-store",
}


class Guard:
    """Stands before an application; a token that comes in an address goes on in a cookie."""

    def __init__(self, app: ASGIApp, access: Access) -> None:
        self._app = app
        self._access = access

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, refuse or pass on."""
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        query = scope["query_string"].decode("latin-1")
        asked = Asked(
            headers.get("host", ""), headers.get("origin"), query, headers.get("cookie", "")
        )
        refusal = self._access.refusal(asked)
        if refusal and scope["type"] == "websocket":
            await WebSocketClose(code=4403, reason=refusal.title)(scope, receive, send)
        elif refusal:
            page = saying_page(refusal.title, refusal.text)
            await HTMLResponse(page, 403, HEADERS)(scope, receive, send)
        elif self._access.brought(query) and scope["type"] == "http":
            answer = self._kept(scope["path"], query, asked.host)
            await answer(scope, receive, send)
        else:
            await self._app(scope, receive, send)

    def _kept(self, path: str, query: str, host: str) -> RedirectResponse:
        """Lead to the address without the token, so that it stays out of bookmarks."""
        rest = without_token(query)
        answer = RedirectResponse(path + (f"?{rest}" if rest else ""), 303, HEADERS)
        name = cookie_name(host)
        answer.set_cookie(name, self._access.token, httponly=True, samesite="strict")
        return answer
